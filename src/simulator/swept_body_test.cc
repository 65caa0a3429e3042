// SPDX-License-Identifier: Apache-2.0
#include "simulator/swept_body.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

SweptBody Rod(double roll = 0) {
  SweptBodyOptions options;
  options.near_cap = options.far_cap = 5.0;
  options.roll = roll;
  return {{0, 0}, {1, 0}, {{0, 0, 10, 6, 5, 4}, {40, 0, 10, 6, 5, 4}}, options};
}

TEST(SweptBodyTest, SectionHasItsHalvesAndBreadth) {
  const SweptBody rod = Rod();
  EXPECT_NEAR(rod.Distance({20, 6, 10}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({20, -6, 10}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({20, 0, 15}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({20, 0, 6}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({45, 0, 10}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({-5, 0, 10}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({20, 0, 16}), 1, 0.1);
  EXPECT_LT(rod.Distance({20, 0, 10}), -3.9);
}

TEST(SweptBodyTest, RollLeansTheBackTowardsTheLeft) {
  const SweptBody rod = Rod(std::numbers::pi / 2);
  EXPECT_NEAR(rod.Distance({20, 5, 10}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({20, -4, 10}), 0, 1e-9);
  EXPECT_NEAR(rod.Distance({20, 0, 16}), 0, 1e-9);
}

TEST(SweptBodyTest, SlopeIsOneOnTheSurface) {
  const SweptBody rod = Rod();
  for (double angle = 0.05; angle < 6.2; angle += 0.1) {
    const Eigen::Vector3d out(0, std::cos(angle), std::sin(angle));
    double lo = 0, hi = 20;
    for (int i = 0; i < 60; ++i)
      (rod.Distance(Eigen::Vector3d(20, 0, 10) + (lo + hi) / 2 * out) < 0 ? lo : hi) = (lo + hi) / 2;
    const Eigen::Vector3d p = Eigen::Vector3d(20, 0, 10) + lo * out;
    Eigen::Vector3d gradient;
    for (int a = 0; a < 3; ++a) {
      const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(a);
      gradient[a] = (rod.Distance(p + step) - rod.Distance(p - step)) / 2e-5;
    }
    EXPECT_NEAR(gradient.norm(), 1.0, 1e-3);
  }
}

TEST(SweptBodyTest, SlantedAxisKeepsItsTrueBreadth) {
  // The same rod, laid along a line 15 degrees off the sweep's direction.
  const double angle = 15 * std::numbers::pi / 180;
  const SweptBody body({0, 0}, {1, 0}, {{0, 0, 10, 6, 5, 5}, {60, 60 * std::tan(angle), 10, 6, 5, 5}});
  const Eigen::Vector3d on_axis(30, 30 * std::tan(angle), 10), across(-std::sin(angle), std::cos(angle), 0);
  EXPECT_NEAR(body.Distance(on_axis + 6 * across), 0, 0.02);
  EXPECT_NEAR(body.Distance(on_axis - 6 * across), 0, 0.02);
}

TEST(SweptBodyTest, FarAwayIsALowerBound) {
  const SweptBody rod = Rod();
  EXPECT_NEAR(rod.Distance({20, 100, 10}), 94, 1e-9);
  EXPECT_GT(rod.Distance({20, 0, 80}), SweptBody::kFar);
}

TEST(SweptBodyTest, SquarerSectionsFillTheCorners) {
  SweptBodyOptions options;
  options.exponent = 2.5;
  const SweptBody square({0, 0}, {1, 0}, {{0, 0, 0, 10, 10, 10}, {30, 0, 0, 10, 10, 10}}, options);
  const double corner = 10 * std::pow(0.5, 1 / 2.5);
  EXPECT_NEAR(square.Distance({15, corner, corner}), 0, 1e-9);
}

TEST(SweptBodyTest, RefusesSectionsOutOfOrder) {
  EXPECT_THROW(SweptBody({0, 0}, {1, 0}, {{0, 0, 0, 1, 1, 1}}), std::logic_error);
  EXPECT_THROW(SweptBody({0, 0}, {1, 0}, {{5, 0, 0, 1, 1, 1}, {5, 0, 0, 1, 1, 1}}), std::logic_error);
}

}  // namespace
}  // namespace dorsum
