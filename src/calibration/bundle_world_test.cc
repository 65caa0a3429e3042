// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_world.h"

#include <cmath>

#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"

namespace dorsum {
namespace {

BundleState TurnedDevice() {
  BundleState state;
  const Camera camera = BundleCamera();
  state.width = camera.width;
  state.height = camera.height;
  state.lens = LensFromCamera(camera);
  state.camera_from_world = PoseFromRigid(camera.camera_from_world);
  for (const double x : {0.0, 12.0}) {
    state.fans.push_back(FanFromGeometry(BundleFan(x, 0.01, FanForm::kFlat)));
  }
  state.planes.push_back({20.0, 0.01, -0.02});
  return state;
}

// Direction of a fan's central stripe on the backplane, from two points of it, rad from the y axis.
double StripeDirection(const DiffractedFan& fan, double y) {
  const auto x_at = [&](double at) {
    double x = fan.origin.x();
    for (int i = 0; i < 50; ++i) {
      const double here = Locate(fan, {x, at, 0.0})->Order(fan);
      x -= here * 1e-3 / (Locate(fan, {x + 1e-3, at, 0.0})->Order(fan) - here);
    }
    return x;
  };
  return std::atan((x_at(y) - x_at(-y)) / (2.0 * y));
}

TEST(BundleWorld, XIsPerpendicularToTheReferencesCentralStripe) {
  BundleState state = TurnedDevice();
  EXPECT_GT(std::abs(StripeDirection(GeometryFromFan(state.fans[1]), 5.0)), 1e-3);
  TurnWorldToCentral(1, &state);
  EXPECT_NEAR(StripeDirection(GeometryFromFan(state.fans[1]), 5.0), 0.0, 2e-5);
}

TEST(BundleWorld, WhatTheCameraSeesStays) {
  const BundleState before = TurnedDevice();
  BundleState after = before;
  TurnWorldToCentral(0, &after);
  for (const std::size_t k : {0U, 1U}) {
    const DiffractedFan was = GeometryFromFan(before.fans[k]), is = GeometryFromFan(after.fans[k]);
    const Eigen::Vector2d there = Project(before.GetCamera(), was.origin - 350.0 * Eigen::Vector3d::UnitZ());
    const Eigen::Vector2d here = Project(after.GetCamera(), is.origin - 350.0 * Eigen::Vector3d::UnitZ());
    EXPECT_LT((there - here).norm(), 1e-6);
    const auto order = [](const BundleState& s, const DiffractedFan& fan) {
      LaserGeometry laser;
      laser.fan = fan;
      return OrderAtHeight(s.GetCamera(), laser, SheetModel::kCone, {420.0, 310.0}, 15.0).value_or(99.0);
    };
    EXPECT_NEAR(order(before, was), order(after, is), 1e-9);
  }
  // A plane's slope turns with the world.
  EXPECT_NEAR(std::hypot(after.planes[0][1], after.planes[0][2]), std::hypot(0.01, -0.02), 1e-12);
  EXPECT_EQ(after.planes[0][0], 20.0);
}

}  // namespace
}  // namespace dorsum
