// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/calibration.h"
#include "surface/surface_point.h"

namespace dorsum {

struct HeightFieldOptions {
  double pitch_mm = 0.5;        // 0.1 to 5
  double max_gap_mm = 12.0;     // widest gap between stripes that is bridged, mm, 0.5 to 50
  double max_slope_deg = 70.0;  // steeper changes between stripes are jumps and stay open, 10 to 89
  double max_outlier_mm = 2.5;  // a crossing further than this from its neighbours' median is left out, mm
};

// Heights over a regular grid of the backplane: row r, column c lies at origin + pitch * (c, r); NaN where
// nothing was seen.
struct HeightField {
  Eigen::Vector2d origin_mm = Eigen::Vector2d::Zero();
  double pitch_mm = 0.5;
  cv::Mat1f z;       // mm; rows along y, columns along x
  int left_out = 0;  // crossings dropped as outliers
};

// Merges the points of all lasers into one height field. For each grid row, every stripe that crosses it
// gives one height (the mean of its points there); crossings that contradict their neighbours are left out;
// between neighbouring crossings heights run straight, unless the gap or the slope is too large or the
// camera does not see the object (`mask`, CV_8UC1) there, so that nothing is bridged over a depth jump or
// between fingers.
HeightField FuseHeightField(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
                            const HeightFieldOptions& options, const Context& context = {});

}  // namespace dorsum
