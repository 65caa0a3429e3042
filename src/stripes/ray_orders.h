// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/calibration.h"

namespace dorsum {

// The diffraction order along one pixel's ray, between two heights, as a cubic in 1 / (H - z), H the camera's
// height: with a camera and a laser equally high, the order is linear in it. Four times OrderAtHeight() thus
// gives the heights of all orders to a tenth of a micrometre or so, far quicker than IntersectSheet() for
// each. Cone sheets where the laser has them, else planes.
class RayOrders {
 public:
  static constexpr std::size_t kHeights = 4;
  using Orders = std::array<double, kHeights>;  // at heights evenly spread from the lowest to the highest

  // None where the ray does not meet the laser's sheets at these heights.
  static std::optional<Orders> Sample(const Camera& camera, const LaserGeometry& laser, double u, double v,
                                      double low_mm, double high_mm);

  RayOrders(double camera_height_mm, double low_mm, double high_mm, const Orders& orders);

  double OrderAt(double height_mm) const;
  double HeightOf(double order) const;  // mm

 private:
  double camera_height_;
  std::array<double, kHeights> w_;             // 1 / (H - z)
  std::array<double, kHeights> coefficients_;  // of Newton's form
};

}  // namespace dorsum
