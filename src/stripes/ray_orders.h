// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/calibration.h"

namespace dorsum {

// The diffraction order along one pixel's ray, between two heights, as a parabola in 1 / (H - z), H the
// camera's height: with a camera and a laser equally high, the order is linear in it. Three times
// OrderAtHeight() thus gives the heights of all orders to some micrometres, far quicker than IntersectSheet()
// for each. Cone sheets where the laser has them, else planes.
class RayOrders {
 public:
  RayOrders(const Camera& camera, const LaserGeometry& laser, double u, double v, double low_mm,
            double high_mm);

  // Whether the ray meets the laser's sheets at these heights; the rest holds only then.
  bool valid() const { return valid_; }
  double OrderAtLow() const { return order_[0]; }
  double OrderAtHigh() const { return order_[2]; }
  double HeightOf(double order) const;  // mm

 private:
  double camera_height_ = 0.0, slope_ = 0.0, curve_ = 0.0;
  std::array<double, 3> order_{}, w_{};
  bool valid_ = false;
};

}  // namespace dorsum
