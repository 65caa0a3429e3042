// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "stripes/device_orders.h"
#include "stripes/stripes.h"

namespace dorsum {

struct BusyPartOptions {
  double near_px = 1.0;  // how far a stripe of the backplane may lie from its place, px, 0.1 to 10
  int margin_cells = 4;  // around what is busy, cells of 8 px, 0 to 100
};

// Where a scan must look at every row. The rest of the picture is the empty backplane: in the surveyed rows
// (ridge_survey.h) around it, all stripes that the calibration foretells lie in their places, for every
// laser, none between them, and the light of the LEDs is what it was. An object as white as the backplane is
// busy because it moves the stripes; one that swallows them, because they are missing.
//   `surveyed`: points of those rows by row and column, one entry per laser in use. `unchanged`: CV_8UC1 of
//   the picture's size, not 0 where the light is the empty
// backplane's. Returns CV_8UC1 of that size, 255 where it is busy.
cv::Mat FindBusyPart(const std::vector<LaserStripes>& surveyed, const DeviceOrders& orders,
                     const cv::Mat& unchanged, const BusyPartOptions& options, const Context& context = {});

}  // namespace dorsum
