// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "jobs/design_device.h"
#include "jobs/stripe_noise.h"

namespace dorsum {

// The surface that a design is judged on.
struct SurfaceAssumption {
  double albedo = 0.4;   // share of green light that it sends back, 0.01 to 1; skin has 0.2 to 0.5
  bool skin = true;      // light wanders under it, as the description's [skin] says; false: matt paint
  int pooled_rows = 31;  // image rows that one point is measured from, 1 to 1000
};

// What one laser gives at one point of the volume, were a level surface there.
struct PointFigures {
  double order = 0.0;  // as a real number
  double beta = 0.0;   // of the ray that comes here
  bool lit = false;    // within the orders, half a spacing beyond the last, and within the fan
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  bool seen = false;          // in the picture
  double order_per_px = 0.0;  // along the image row at this height
  double order_per_mm = 0.0;  // along the camera's ray, per mm of height
  double spacing_mm = 0.0;    // between neighbouring stripes, on the level surface
  double SpacingPx() const { return 1.0 / std::abs(order_per_px); }
  // How much higher the surface is when the stripe lies a pixel further along the row, without sign.
  double DepthPerPx() const { return std::abs(order_per_px / order_per_mm); }
};

// None where the laser's light does not come, whatever the order.
std::optional<PointFigures> FiguresAt(const DesignedDevice& device, const DesignedLaser& laser,
                                      const Eigen::Vector3d& point);

// The profile of the laser's nearest stripe, were it at this point.
StripeProfile ProfileAt(const DesignedDevice& device, const DesignedLaser& laser,
                        const Eigen::Vector3d& point, const PointFigures& figures,
                        const SurfaceAssumption& surface);

// The order along the camera's ray through a pixel at a height; none where ray or light do not come there.
std::optional<double> OrderAlongRay(const Ray& ray, const DesignedLaser& laser, double z);

}  // namespace dorsum
