// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include <Eigen/Core>
#include <ceres/sized_cost_function.h>

#include "calibration/bundle_model.h"

// For sources only, as bundle_functions.h.
namespace dorsum {

// How far the order that the model finds at a stripe point is from the order that the point has, in standard
// deviations. Parameters: lens, camera_from_world, plane, fan. Derivatives go step by step (pixel, place on
// the plane, order), each for the few parameters that it has, which takes a third of the time of all
// parameters at once.
class StripeResidual : public ceres::SizedCostFunction<1, kLensSize, kPoseSize, kPlaneSize, kFanSize> {
 public:
  StripeResidual(Eigen::Matrix3d camera_start, Eigen::Matrix3d fan_start, Eigen::Vector2d pixel, int order,
                 double sd_orders)
      : camera_start_(std::move(camera_start)),
        fan_start_(std::move(fan_start)),
        pixel_(std::move(pixel)),
        order_(order),
        sd_(sd_orders) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  Eigen::Matrix3d camera_start_, fan_start_;
  Eigen::Vector2d pixel_;
  int order_;
  double sd_;
};

}  // namespace dorsum
