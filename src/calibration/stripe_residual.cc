// SPDX-License-Identifier: Apache-2.0
#include "calibration/stripe_residual.h"

#include <array>
#include <cstddef>

#include "calibration/bundle_functions.h"

namespace dorsum {
namespace {

using bundle::Vector2;
using bundle::Vector3;

// Numbers with derivatives for `count` parameters from place `first` on; an even width is quicker.
template <int kWidth, int kCount>
std::array<ceres::Jet<double, kWidth>, kCount> Free(const double* values, int first) {
  std::array<ceres::Jet<double, kWidth>, kCount> out;
  for (int i = 0; i < kCount; ++i) {
    out[static_cast<std::size_t>(i)] = ceres::Jet<double, kWidth>(values[i], first + i);
  }
  return out;
}

}  // namespace

bool StripeResidual::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const double *lens = parameters[0], *camera = parameters[1], *plane = parameters[2], *fan = parameters[3];
  if (jacobians == nullptr) {
    const Vector3<double> p =
        bundle::PointOnPlane<double>(bundle::UndistortPixel(lens, pixel_), camera_start_, camera, plane);
    residuals[0] = (bundle::OrderAt<double>(fan_start_, fan, p) - order_) / sd_;
    return true;
  }
  using JetA = ceres::Jet<double, kLensSize + 1>;
  const Vector2<JetA> place = bundle::UndistortPixel(Free<kLensSize + 1, kLensSize>(lens, 0).data(), pixel_);

  constexpr int kB = 2 + kPoseSize + kPlaneSize + 1;
  using JetB = ceres::Jet<double, kB>;
  const Vector2<JetB> n(JetB(place[0].a, 0), JetB(place[1].a, 1));
  const Vector3<JetB> point =
      bundle::PointOnPlane<JetB>(n, camera_start_, Free<kB, kPoseSize>(camera, 2).data(),
                                 Free<kB, kPlaneSize>(plane, 2 + kPoseSize).data());

  constexpr int kC = 3 + kFanSize;
  using JetC = ceres::Jet<double, kC>;
  const Vector3<JetC> world(JetC(point[0].a, 0), JetC(point[1].a, 1), JetC(point[2].a, 2));
  const JetC order = bundle::OrderAt<JetC>(fan_start_, Free<kC, kFanSize>(fan, 3).data(), world);
  residuals[0] = (order.a - order_) / sd_;

  Eigen::Matrix<double, kB, 1> of_b = Eigen::Matrix<double, kB, 1>::Zero();
  for (int i = 0; i < 3; ++i) of_b += order.v[i] / sd_ * point[i].v;
  if (jacobians[0] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, kLensSize, 1>> out(jacobians[0]);
    out = of_b[0] * place[0].v.template head<kLensSize>() + of_b[1] * place[1].v.template head<kLensSize>();
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, kPoseSize, 1>> out(jacobians[1]);
    out = of_b.segment<kPoseSize>(2);
  }
  if (jacobians[2] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, kPlaneSize, 1>> out(jacobians[2]);
    out = of_b.segment<kPlaneSize>(2 + kPoseSize);
  }
  if (jacobians[3] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, kFanSize, 1>> out(jacobians[3]);
    out = order.v.tail<kFanSize>() / sd_;
  }
  return true;
}

}  // namespace dorsum
