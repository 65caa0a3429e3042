// SPDX-License-Identifier: Apache-2.0
#include "captures/designed_geometry.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(DesignedGeometryTest, TheCameraHasItsTargetInMidPictureAndItsRowsLevel) {
  CameraDesign design;
  design.position_mm = {-118.0, 30.0, 386.0};
  design.look_at_mm = {14.0, -5.0, 0.0};
  const Camera camera = DesignedCamera(design);
  EXPECT_LT((camera.Center() - design.position_mm).norm(), 1e-9);
  const Eigen::Vector2d target = Project(camera, design.look_at_mm);
  EXPECT_NEAR(target.x(), 799.5, 1e-9);
  EXPECT_NEAR(target.y(), 599.5, 1e-9);
  // u grows with x, v falls with y.
  const Eigen::Vector2d right = Project(camera, design.look_at_mm + 10.0 * Eigen::Vector3d::UnitX());
  const Eigen::Vector2d up = Project(camera, design.look_at_mm + 10.0 * Eigen::Vector3d::UnitY());
  EXPECT_GT(right.x(), target.x());
  EXPECT_LT(up.y(), target.y());
  // Nothing is closer to x than the rows, among the directions across the view.
  const Eigen::Matrix3d& r = camera.camera_from_world.rotation;
  EXPECT_NEAR(r.row(1).x(), 0.0, 1e-12);
  EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
}

TEST(DesignedGeometryTest, TheFanSpreadsAlongYAndItsOrdersAlongX) {
  const DeviceDescription d = DefaultDevice();
  const DiffractedFan fan = DesignedFan(d.lasers[2], d.grating);
  for (const int order : {-10, 0, 1}) {
    const auto ray = DiffractedRay(fan, order, 0.0);
    ASSERT_TRUE(ray.has_value());
    const auto t = Intersect(*ray, Plane{});
    ASSERT_TRUE(t.has_value());
    // Equation 2.6 with the turn's cosine, straight below the grating at 395 mm.
    const double sine = order * 532e-6 * 100.0 * std::cos(std::numbers::pi / 4.0);
    EXPECT_NEAR(ray->At(*t).x(), 11.15 + 395.0 * std::tan(std::asin(sine)), 1e-9) << order;
    EXPECT_NEAR(ray->At(*t).y(), 0.0, 1e-9);
  }
  const auto side = DiffractedRay(fan, 0, 0.3);
  ASSERT_TRUE(side.has_value());
  EXPECT_NEAR(side->direction.x(), 0.0, 1e-12);
  EXPECT_NEAR(side->direction.y(), -0.3, 1e-12);
}

TEST(DesignedGeometryTest, ATiltedLaserLeansTowardsX) {
  LaserDesign laser;
  laser.tilt_deg = 10.0;
  const auto ray = DiffractedRay(DesignedFan(laser, {}), 0, 0.0);
  ASSERT_TRUE(ray.has_value());
  EXPECT_NEAR(std::atan2(ray->direction.x(), -ray->direction.z()), 10.0 * std::numbers::pi / 180.0, 1e-12);
}

}  // namespace
}  // namespace dorsum
