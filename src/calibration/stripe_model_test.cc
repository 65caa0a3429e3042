// SPDX-License-Identifier: Apache-2.0
#include "calibration/stripe_model.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"
#include "geometry/calibration.h"

namespace dorsum {
namespace {

// A state in which nothing is zero, so that no derivative hides.
struct Leaning {
  LensParameters lens{{900.0, 905.0, 400.0, 300.0, -0.1, 0.04, 1e-3, -5e-4, 0.01}};
  PoseParameters pose;
  FanParameters fan;
  std::array<double, kPlaneSize> plane{20.0, 0.01, -0.02};

  Leaning() {
    const Eigen::Matrix3d down = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
    pose.start = fan.start = down;
    pose.value = {0.02, -0.01, 0.3, 4.0, -6.0, 410.0};
    fan.value = {60.0, 10.0, 400.0, 0.01, 0.2, -0.01, 12.0, 0.05, 0.01, 0.03, 0.05};
  }
  StripeModel Model() const { return {lens, pose, fan, plane}; }
  // In the order of StripeDerivatives.
  std::vector<double*> All() {
    std::vector<double*> all;
    all.reserve(kStripeSize);
    for (double& x : lens.value) all.push_back(&x);
    for (double& x : pose.value) all.push_back(&x);
    for (double& x : fan.value) all.push_back(&x);
    for (double& x : plane) all.push_back(&x);
    return all;
  }
};

TEST(StripeModel, AgreesWithTheGeometryLayer) {
  const BundleFixture device;
  for (std::size_t k = 0; k < device.fans.size(); ++k) {
    LaserGeometry laser;
    laser.fan = device.fans[k];
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(20, 30), {400, 300}, {780, 590}}) {
      for (const double z : {0.0, 40.0}) {
        const StripeModel model(device.truth.lens, device.truth.camera_from_world, device.truth.fans[k],
                                {z, 0.0, 0.0});
        const auto expected = OrderAtHeight(device.camera, laser, SheetModel::kCone, pixel, z);
        ASSERT_TRUE(expected.has_value());
        EXPECT_NEAR(model.Order(pixel), expected.value_or(1e9), 1e-11);
        const Ray ray = CastRay(device.camera, pixel);
        const double t = (z - ray.origin.z()) / ray.direction.z();
        EXPECT_LT((model.Place(pixel) - ray.At(t)).norm(), 1e-9);
      }
    }
  }
}

TEST(StripeModel, DerivativesAreThoseOfFiniteDifferences) {
  Leaning state;
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(310, 250), {30, 20}, {760, 570}}) {
    StripeSearch search;
    StripeDerivatives derivatives{};
    const double order = state.Model().Order(pixel, true, &search, &derivatives);
    EXPECT_NEAR(order, state.Model().Order(pixel), 1e-12);
    const std::vector<double*> all = state.All();
    ASSERT_EQ(all.size(), derivatives.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double old = *all[i], step = 1e-6 * std::max(1.0, std::abs(old));
      *all[i] = old + step;
      const double above = state.Model().Order(pixel);
      *all[i] = old - step;
      const double below = state.Model().Order(pixel);
      *all[i] = old;
      const double slope = (above - below) / (2.0 * step);
      EXPECT_NEAR(derivatives[i], slope, 1e-6 * std::max(0.1, std::abs(slope))) << i;
    }
  }
}

TEST(StripeModel, ASearchThatBeginsElsewhereEndsAtTheSamePlace) {
  Leaning state;
  const Eigen::Vector2d pixel(730.0, 520.0);
  StripeSearch search;
  state.Model().Order({40.0, 60.0}, &search);
  ASSERT_TRUE(search.begun);
  EXPECT_NEAR(state.Model().Order(pixel, &search), state.Model().Order(pixel), 1e-12);
}

TEST(StripeModel, WhatAFanDoesNotReachIsNotFiniteAndIsForgotten) {
  Leaning state;
  state.fan.value[kFanAlpha] = 1.2;  // no sine
  StripeSearch search;
  EXPECT_FALSE(std::isfinite(state.Model().Order({310.0, 250.0}, &search)));
  EXPECT_FALSE(search.begun);
}

TEST(StripeModel, ChangeAlongTheRowIsThatOfNeighbours) {
  const Leaning state;
  const StripeModel model = state.Model();
  const Eigen::Vector2d pixel(610.0, 120.0), half(0.5, 0.0);
  const StripeModel::Along along = model.OrderAlong(pixel);
  EXPECT_NEAR(along.order, model.Order(pixel), 1e-12);
  EXPECT_NEAR(along.orders_per_px, std::abs(model.Order(pixel + half) - model.Order(pixel - half)), 1e-7);
  EXPECT_NEAR(along.mm_per_px, std::abs(model.Place(pixel + half).x() - model.Place(pixel - half).x()), 1e-6);
}

}  // namespace
}  // namespace dorsum
