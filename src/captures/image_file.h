// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "captures/jpeg_image.h"

namespace dorsum {

// Largest image that is read: 100 megapixels, more than any camera of this kind has.
inline constexpr long kMaxPixels = 100'000'000;

// DIR/NAME.png, .jpg or .jpeg, whichever is there; none when there is no such file.
std::optional<std::filesystem::path> FindImage(const std::filesystem::path& dir, const std::string& name);

// The same, or the sentence that names what is missing.
Result<std::filesystem::path> RequireImage(const std::filesystem::path& dir, const std::string& name);

// Reads an 8-bit colour PNG or JPEG as it was captured (BGR, CV_8UC3; orientation tags are ignored, since
// the calibration knows pixels as they lie on the sensor). Refuses, in one sentence: missing, truncated,
// damaged, grey, with alpha, of another depth, larger than kMaxPixels, or of another size than expected.
// With Channels::kGreen, gives its green channel alone (CV_8UC1).
Result<cv::Mat> ReadImage(const std::filesystem::path& path, std::optional<cv::Size> expected = std::nullopt,
                          Channels channels = Channels::kBgr);

// Decodes an image from memory under the same rules; `name` stands for the file in messages.
Result<cv::Mat> DecodeImage(const std::string& bytes, const std::string& name,
                            std::optional<cv::Size> expected = std::nullopt,
                            Channels channels = Channels::kBgr);

// Refuses an image, in colour or green alone, with no contrast in its green channel: it was taken with the
// light off, or is overexposed throughout.
Status CheckExposure(const cv::Mat& image, const std::string& name);

}  // namespace dorsum
