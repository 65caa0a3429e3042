// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace dorsum {

enum class Channels : std::uint8_t { kBgr, kGreen };

// Decodes a colour JPEG of this size to BGR (CV_8UC3), with the same values as cv::imdecode, or to the green
// channel of that alone (CV_8UC1), without a picture of all three in between. Unlike cv::imdecode,
// refuses one whose compressed data is damaged, with an empty image, and writes nothing to the standard
// error. Damage is known by codes that do not exist and by too much or too little data; ITU-T T.81 has no
// checksum, so a few changed bytes that leave neither go unseen. Up to kJpegPadding stray bytes before the
// end marker pass: some webcams write them.
cv::Mat DecodeJpeg(std::string_view bytes, cv::Size size, Channels channels = Channels::kBgr);

inline constexpr int kJpegPadding = 16;  // bytes

// JPEG of a grey or BGR picture of 8 bits, `quality` 1 to 100, colour at half the resolution as is usual.
// `optimise` makes it a few percent smaller, in twice the time. The same picture gives the same bytes.
std::string EncodeJpeg(const cv::Mat& image, int quality, bool optimise = false);

}  // namespace dorsum
