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

  // What the rays of one device have in common: the heights, which are the nodes of Newton's form.
  class Nodes {
   public:
    Nodes(double camera_height_mm, double low_mm, double high_mm);

    // None where the ray does not meet the laser's sheets at these heights.
    std::optional<Orders> Sample(const Camera& camera, const LaserGeometry& laser, double u, double v) const;

    // Newton's divided differences of some orders. They are linear in the orders, so that those of a pixel
    // may be interpolated between those of others.
    Orders Differences(const Orders& orders) const;

    double W(double height_mm) const { return 1.0 / (camera_height_ - height_mm); }
    double HeightAt(double w) const { return camera_height_ - 1.0 / w; }
    double w(std::size_t i) const { return w_[i]; }

   private:
    double camera_height_;
    Orders heights_{}, w_{};  // w: 1 / (H - z)
  };

  // `nodes` must outlive it. `differences`: Nodes::Differences() of the ray's orders.
  RayOrders(const Nodes& nodes, const Orders& differences) : nodes_(&nodes), coefficients_(differences) {}

  double OrderAt(double height_mm) const;
  double HeightOf(double order) const;  // mm

 private:
  const Nodes* nodes_;
  Orders coefficients_;  // of Newton's form
};

}  // namespace dorsum
