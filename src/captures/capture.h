// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "captures/jpeg_image.h"

namespace dorsum {

// The images of one capture (§3.3), BGR, all of one size. Those of stripes may be their green channel alone
// (CV_8UC1), which is all that a reconstruction from ridges looks at.
struct CaptureImages {
  cv::Mat hand;  // bgHand
  std::vector<std::optional<cv::Mat>>
      stripes;                        // stripesHandK by laser; none where that laser was not captured
  std::optional<cv::Mat> hand_after;  // bgHandAfter
  std::vector<std::string> warnings;  // one sentence each
};

// What is said where the image of a laser's stripes is missing in a capture folder.
std::string MissingStripes(const std::filesystem::path& dir, int laser);

// Loads a capture folder. All images must be of the `expected` size, or of bgHand's if that is empty.
// `lasers` are those that the calibration knows; a missing image of one of them is a warning, and an error
// only when all are missing. Refuses images that show nothing: all black, all white. Images are decoded on
// `context`'s threads; those of stripes to `stripes`.
Result<CaptureImages> LoadCapture(const std::filesystem::path& dir, cv::Size expected,
                                  const std::vector<int>& lasers, const Context& context = {},
                                  Channels stripes = Channels::kBgr);

}  // namespace dorsum
