// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_problem.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "calibration/bundle_device_test.h"

namespace dorsum {
namespace {

// Height error of a solution over the working volume, along the true rays.
double HeightError(const BundleFixture& device, const BundleState& state) {
  double worst = 0.0;
  for (std::size_t k = 0; k < device.fans.size(); ++k) {
    LaserGeometry laser;
    laser.fan = GeometryFromFan(state.fans[k]);
    for (const double z : {0.0, 40.0, 80.0}) {
      for (int order = -8; order <= 8; order += 4) {
        for (const double v : {20.0, 300.0, 580.0}) {
          const auto u = SheetColumn(device.camera, device.fans[k], order, v, z);
          if (!u) continue;
          const auto at =
              IntersectSheet(CastRay(state.GetCamera(), {*u, v}), laser, SheetModel::kCone, order);
          EXPECT_TRUE(at.has_value());
          if (at) worst = std::max(worst, std::abs(at->z() - z));
        }
      }
    }
  }
  return worst;
}

TEST(BundleProblem, PerfectObservationsGiveTheDeviceBack) {
  const BundleFixture device;
  const auto solution = SolveBundle(device.data, device.Start(), {}, {});
  ASSERT_TRUE(solution.ok()) << solution.error().message;
  EXPECT_LT(HeightError(device, solution->state), 0.002);
  EXPECT_NEAR(solution->state.lens.value[0], device.camera.fx, 0.05);
  for (std::size_t k = 0; k < device.fans.size(); ++k) {
    const auto& fan = solution->state.fans[k].value;
    EXPECT_NEAR(fan[kFanStep], device.fans[k].step, 2e-6);
    EXPECT_NEAR(fan[kFanBow], EffectiveBow(device.fans[k]), 1e-3) << "the fan's form was not found";
    EXPECT_NEAR(fan[kFanDistance], device.fans[k].fan_distance_mm, 0.2);
  }
}

TEST(BundleProblem, OutliersAndGapsDoNoHarm) {
  BundleFixture device;
  Rng rng(7);
  std::erase_if(device.data.points, [](const SheetPoint& p) { return p.order == 3; });
  for (SheetPoint& p : device.data.points) {
    if (rng.Uniform(0.0, 1.0) < 0.03) p.u += rng.Uniform(-8.0, 8.0);
  }
  const auto solution = SolveBundle(device.data, device.Start(), {}, {});
  ASSERT_TRUE(solution.ok());
  EXPECT_LT(HeightError(device, solution->state), 0.01);
}

TEST(BundleProblem, UncertaintiesAreThoseThatNoiseCauses) {
  BundleFixture device;
  Rng rng(3);
  for (SheetPoint& p : device.data.points) p.u += 0.1 * rng.Normal();
  for (SheetPoint& p : device.data.points) p.sd_px = 0.1;
  BundleProblemOptions options;
  options.uncertainties = true;
  options.point_sd_px = 0.0;
  const auto solution = SolveBundle(device.data, device.Start(), options, {});
  ASSERT_TRUE(solution.ok());
  ASSERT_EQ(solution->covariance.rows(), kLensSize + kPoseSize + 2 * kFanSize);
  EXPECT_NEAR(solution->variance_factor, 1.1, 0.5);
  for (int k = 0; k < 2; ++k) {
    const int at = kLensSize + kPoseSize + k * kFanSize + kFanStep;
    const double sd = std::sqrt(solution->covariance(at, at));
    EXPECT_LT(std::abs(solution->state.fans[static_cast<std::size_t>(k)].value[kFanStep] - 0.0376), 4.0 * sd);
    EXPECT_LT(sd, 1e-4);
    EXPECT_GT(sd, 1e-7);
  }
  ASSERT_EQ(solution->height_sd.size(), 3U);
  EXPECT_EQ(solution->height_sd[0], 0.0) << "the backplane is height 0 by definition";
  EXPECT_GT(solution->height_sd[1], 0.0);
}

TEST(BundleProblem, StopsWhenCancelled) {
  const BundleFixture device;
  std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const auto solution = SolveBundle(device.data, device.Start(), {}, context);
  ASSERT_FALSE(solution.ok());
  EXPECT_EQ(solution.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
