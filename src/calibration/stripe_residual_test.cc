// SPDX-License-Identifier: Apache-2.0
#include "calibration/stripe_residual.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(StripeResidual, ItsDerivativesAreThoseOfItsValue) {
  const Eigen::Matrix3d down = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  const StripeResidual residual(down, down, {310.0, 250.0}, 2, 0.02);
  std::array<double, kLensSize> lens{900.0, 905.0, 400.0, 300.0, -0.1, 0.04, 1e-3, -5e-4, 0.01};
  std::array<double, kPoseSize> camera{0.02, -0.01, 0.03, 4.0, -6.0, 410.0};
  std::array<double, kPlaneSize> plane{20.0, 0.01, -0.02};
  std::array<double, kFanSize> fan{60.0, 10.0, 400.0, 0.01, 0.02, -0.01, 0.0, 0.0, 0.0, 0.0, 0.0};
  fan[kFanDistance] = 12.0;
  fan[kFanAlpha] = 0.05;
  fan[kFanSkew] = 0.01;
  fan[kFanBow] = 0.03;
  fan[kFanStep] = 0.05;
  const std::array<double*, 4> blocks = {lens.data(), camera.data(), plane.data(), fan.data()};
  const std::array<int, 4> sizes = {kLensSize, kPoseSize, kPlaneSize, kFanSize};
  std::array<std::array<double, kFanSize>, 4> derivatives{};
  std::array<double*, 4> jacobians{};
  for (std::size_t b = 0; b < 4; ++b) jacobians[b] = derivatives[b].data();
  double value = 0.0, plain = 0.0;
  ASSERT_TRUE(residual.Evaluate(blocks.data(), &value, jacobians.data()));
  ASSERT_TRUE(residual.Evaluate(blocks.data(), &plain, nullptr));
  EXPECT_NEAR(value, plain, 1e-9);
  for (std::size_t b = 0; b < 4; ++b) {
    for (int i = 0; i < sizes[b]; ++i) {
      double& x = blocks[b][i];
      const double old = x, step = 1e-6 * std::max(1.0, std::abs(old));
      double above = 0.0, below = 0.0;
      x = old + step;
      residual.Evaluate(blocks.data(), &above, nullptr);
      x = old - step;
      residual.Evaluate(blocks.data(), &below, nullptr);
      x = old;
      const double slope = (above - below) / (2.0 * step);
      EXPECT_NEAR(derivatives[b][static_cast<std::size_t>(i)], slope, 1e-4 * std::max(1.0, std::abs(slope)))
          << "block " << b << ", " << i;
    }
  }
}

TEST(StripeResidual, ConstantBlocksAreLeftOut) {
  const Eigen::Matrix3d down = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  const StripeResidual residual(down, down, {310.0, 250.0}, 2, 0.02);
  std::array<double, kLensSize> lens{900.0, 905.0, 400.0, 300.0};
  std::array<double, kPoseSize> camera{0.0, 0.0, 0.0, 0.0, 0.0, 410.0};
  std::array<double, kPlaneSize> plane{};
  std::array<double, kFanSize> fan{60.0, 10.0, 400.0};
  fan[kFanStep] = 0.05;
  const std::array<const double*, 4> blocks = {lens.data(), camera.data(), plane.data(), fan.data()};
  std::array<double*, 4> jacobians{};
  double value = NAN;
  ASSERT_TRUE(residual.Evaluate(blocks.data(), &value, jacobians.data()));
  EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace dorsum
