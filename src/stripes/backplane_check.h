// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "stripes/device_orders.h"
#include "stripes/stripes.h"

namespace dorsum {

struct BackplaneCheckOptions {
  double max_shift_px = 0.6;  // usual distance of backplane stripes from where they belong, px, 0.1 to 10
  double near_px = 2.0;       // stripes this close to each other's shift share it, px, 0.5 to 20
  double min_share = 0.4;  // share of a laser's points that must share a shift, else nothing is said, 0 to 1
  int min_points = 40;     // of a laser, fewer say nothing
};

// Whether a laser's stripes on the backplane lie where the calibration has them.
struct BackplaneCheck {
  int laser = 0;
  int points = 0;         // looked at
  double shift_px = 0.0;  // usual distance along u of the stripes from their places, px
  bool moved = false;     // camera or laser stand otherwise than when they were calibrated
};

// Compares the stripe points on the `empty` part of the picture (CV_8UC1, not 0 where light and colour are
// those of the empty backplane) with the nearest stripe that the backplane would show. An object moves
// stripes by all distances; a camera or laser that was knocked moves most of the backplane's by about the
// same. So the shift that most points share is looked for. `stripes` need no orders. One entry per laser of
// `stripes` that `device` knows.
std::vector<BackplaneCheck> CheckBackplane(const std::vector<LaserStripes>& stripes,
                                           const DeviceOrders& orders, const cv::Mat& empty,
                                           const BackplaneCheckOptions& options);

}  // namespace dorsum
