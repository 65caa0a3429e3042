// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <opencv2/core.hpp>

#include "report/plot.h"
#include "surface/height_field.h"

namespace dorsum {

struct HeightPictureOptions {
  int width_px = 1200, height_px = 900;  // at most, with the axes, 320 to 4000
  double contour_mm = 5.0;               // distance of contour lines; 0: none
  double relief = 0.35;                  // how much slopes shade the colours, 0 to 1
  std::optional<Range> range_mm = {};    // of the colour scale; none: from the heights
};

// A height field as a map: x to the right and y up, as the camera sees it, both in mm at the same scale;
// colour scale in mm, contour lines, white where nothing was seen.
cv::Mat DrawHeightMap(const HeightField& field, const HeightPictureOptions& options = {});

}  // namespace dorsum
