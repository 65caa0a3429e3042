// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

struct OverviewTile {
  cv::Mat picture;  // BGR; empty gives an empty frame with the caption
  std::string caption;
};

struct OverviewOptions {
  int width_px = 1800;  // 300 to 6000
  int columns = 3;      // 1 to 8
};

// One picture of many: a title, a line of figures, and tiles in reading order with captions.
cv::Mat OverviewPicture(const std::string& title, const std::string& subtitle,
                        const std::vector<OverviewTile>& tiles, const OverviewOptions& options = {});

}  // namespace dorsum
