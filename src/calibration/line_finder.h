// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

struct LineFinderOptions {
  double max_tilt_deg = 20.0;      // against the vertical, 0 to 45
  double min_length_share = 0.35;  // of the image's height, 0 to 1
  double max_gap_px = 12.0;
  double merge_px = 10.0;  // lines closer than this are one, px
};

// One nearly vertical straight line, as x = at + slope * (row - middle row).
struct VerticalLine {
  double at = 0.0;          // column at the image's middle row, px
  double slope = 0.0;       // columns per row
  double weight = 0.0;      // summed length of what was found, px
  double brightness = 0.0;  // mean of `intensity` along the line, if given
};

// Straight lines in a binary image by the probabilistic Hough transform (LineFinder, §4.5), pieces of one
// line merged, by growing column. `intensity` (CV_8UC1, same size, may be empty) gives their brightness.
std::vector<VerticalLine> FindVerticalLines(const cv::Mat& mask, const cv::Mat& intensity,
                                            const LineFinderOptions& options);

}  // namespace dorsum
