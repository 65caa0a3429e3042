// SPDX-License-Identifier: Apache-2.0
#include "captures/capture.h"

#include <algorithm>

#include "captures/image_file.h"
#include "captures/names.h"

namespace dorsum {

Result<CaptureImages> LoadCapture(const std::filesystem::path& dir, cv::Size expected,
                                  const std::vector<int>& lasers) {
  std::error_code ec;
  if (!std::filesystem::is_directory(dir, ec)) return BadInput("there is no capture folder " + dir.string());
  CaptureImages capture;
  DORSUM_ASSIGN_OR_RETURN(const auto hand_path, RequireImage(dir, kBgHandName));
  const std::optional<cv::Size> wanted = expected.empty() ? std::nullopt : std::optional(expected);
  DORSUM_ASSIGN_OR_RETURN(capture.hand, ReadImage(hand_path, wanted));
  const cv::Size size = capture.hand.size();
  DORSUM_RETURN_IF_ERROR(CheckExposure(capture.hand, hand_path.string()));
  int found = 0;
  for (const int laser : lasers) {
    const std::string name = StripesHandName(laser);
    capture.stripes.resize(
        std::max<std::size_t>(capture.stripes.size(), static_cast<std::size_t>(laser) + 1));
    const auto path = FindImage(dir, name);
    if (!path) {
      capture.warnings.push_back("the image " + name + " is missing in " + dir.string() + "; laser " +
                                 std::to_string(laser) + " gives no points");
      continue;
    }
    DORSUM_ASSIGN_OR_RETURN(cv::Mat image, ReadImage(*path, size));
    DORSUM_RETURN_IF_ERROR(CheckExposure(image, path->string()));
    capture.stripes[static_cast<std::size_t>(laser)] = std::move(image);
    ++found;
  }
  if (found == 0) return BadInput("there is no image stripesHand0, stripesHand1, … in " + dir.string());
  if (const auto after = FindImage(dir, kBgHandAfterName)) {
    DORSUM_ASSIGN_OR_RETURN(cv::Mat image, ReadImage(*after, size));
    capture.hand_after = std::move(image);
  }
  return capture;
}

}  // namespace dorsum
