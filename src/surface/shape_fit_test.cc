// SPDX-License-Identifier: Apache-2.0
#include "surface/shape_fit.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// What a camera sees of a sphere: a cap that reaches 60 degrees from its top.
Points SphereCap(double radius, double noise, double cap_deg = 60.0) {
  Rng rng(7);
  Points points;
  for (int i = 0; i < 3000; ++i) {
    const double cosine = rng.Uniform(std::cos(cap_deg * std::numbers::pi / 180.0), 1.0);
    const double turn = rng.Uniform(0.0, 2.0 * std::numbers::pi);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double r = radius + noise * rng.Normal();
    points.emplace_back(12.0 + r * sine * std::cos(turn), -5.0 + r * sine * std::sin(turn), 3.0 + r * cosine);
  }
  return points;
}

// The upper part of a lying cylinder, turned by `yaw` and tipped by `pitch`.
Points CylinderTop(double radius, double half_length, double yaw, double pitch, double noise) {
  Rng rng(9);
  const Eigen::Vector3d axis(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch),
                             std::sin(pitch));
  const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(axis).normalized(), up = axis.cross(side);
  Points points;
  for (int i = 0; i < 3000; ++i) {
    const double turn = rng.Uniform(-1.0, 1.0), r = radius + noise * rng.Normal();
    points.emplace_back(Eigen::Vector3d(4, 6, 2) + rng.Uniform(-half_length, half_length) * axis +
                        r * (std::sin(turn) * side + std::cos(turn) * up));
  }
  return points;
}

TEST(ShapeFitTest, SphereFromItsCap) {
  const auto exact = FitShape(Shape::kSphere, SphereCap(40.0, 0.0));
  ASSERT_TRUE(exact.ok()) << exact.error().message;
  EXPECT_NEAR(exact->radius_mm, 40.0, 1e-6);
  EXPECT_LT((exact->center - Eigen::Vector3d(12, -5, 3)).norm(), 1e-6);
  const auto noisy = FitShape(Shape::kSphere, SphereCap(40.0, 0.5));
  ASSERT_TRUE(noisy.ok());
  EXPECT_NEAR(noisy->radius_mm, 40.0, 0.3);
}

TEST(ShapeFitTest, CylinderLongOrShortAndTipped) {
  for (const double half_length : {60.0, 30.0}) {
    for (const double pitch : {0.0, 0.2}) {
      const auto fit = FitShape(Shape::kCylinder, CylinderTop(20.0, half_length, 0.4, pitch, 0.0));
      ASSERT_TRUE(fit.ok()) << fit.error().message;
      EXPECT_NEAR(fit->radius_mm, 20.0, 1e-5) << half_length << ", " << pitch;
      const Eigen::Vector3d axis(std::cos(0.4) * std::cos(pitch), std::sin(0.4) * std::cos(pitch),
                                 std::sin(pitch));
      EXPECT_NEAR(std::abs(fit->axis.dot(axis)), 1.0, 1e-9);
      EXPECT_NEAR(fit->Distance({4, 6, 2}), -20.0, 1e-5) << "a point of the axis";
    }
  }
  const auto noisy = FitShape(Shape::kCylinder, CylinderTop(20.0, 50.0, 0.4, 0.1, 0.3));
  ASSERT_TRUE(noisy.ok());
  EXPECT_NEAR(noisy->radius_mm, 20.0, 0.2);
}

// A thick cylinder of which the camera sees a short piece is wider than long.
TEST(ShapeFitTest, CylinderSeenWiderThanLong) {
  const auto fit = FitShape(Shape::kCylinder, CylinderTop(60.0, 25.0, 0.4, 0.0, 0.0));
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  EXPECT_NEAR(fit->radius_mm, 60.0, 1e-3);
}

TEST(ShapeFitTest, PlaneLooksUp) {
  Points points;
  for (int i = 0; i < 100; ++i) points.emplace_back(i % 10, i / 10, 5.0 + 0.3 * (i % 10));
  const auto fit = FitShape(Shape::kPlane, points);
  ASSERT_TRUE(fit.ok());
  EXPECT_GT(fit->axis.z(), 0.0);
  EXPECT_NEAR(fit->axis.normalized().dot(Eigen::Vector3d(-0.3, 0.0, 1.0).normalized()), 1.0, 1e-9);
  EXPECT_NEAR(fit->Distance({0.0, 0.0, 7.0}), 2.0 / std::hypot(1.0, 0.3), 1e-9) << "positive above";
}

TEST(ShapeFitTest, PointsThatDetermineNoShapeAreRefused) {
  EXPECT_FALSE(FitShape(Shape::kSphere, Points(9, Eigen::Vector3d::Zero())).ok()) << "too few";
  Points flat, line;
  for (int i = 0; i < 400; ++i) {
    flat.emplace_back(i % 20, i / 20, 5.0);
    line.emplace_back(i, 0.0, 5.0);
  }
  for (const Shape shape : {Shape::kSphere, Shape::kCylinder}) {
    EXPECT_FALSE(FitShape(shape, flat).ok()) << static_cast<int>(shape);
    EXPECT_FALSE(FitShape(shape, line).ok()) << static_cast<int>(shape);
    // Neither a line nor a place has one cylinder or sphere.
    EXPECT_FALSE(FitShape(shape, Points(50, Eigen::Vector3d(1, 2, 3))).ok()) << static_cast<int>(shape);
  }
}

}  // namespace
}  // namespace dorsum
