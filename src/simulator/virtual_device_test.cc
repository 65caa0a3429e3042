// SPDX-License-Identifier: Apache-2.0
#include "simulator/virtual_device.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "simulator/small_device_test.h"

namespace dorsum {
namespace {

double OrderAt(const VirtualLaser& laser, const Eigen::Vector3d& point) {
  const auto at = Locate(laser.fan, point);
  EXPECT_TRUE(at.has_value());
  return at ? at->Order(laser.fan) : NAN;
}

void ExpectWorldFrame(const VirtualDevice& device) {
  const VirtualLaser& laser = device.lasers[static_cast<std::size_t>(WorldLaser(device))];
  EXPECT_NEAR(OrderAt(laser, Eigen::Vector3d::Zero()), 0.0, 1e-9) << "the origin lies on the central stripe";
  constexpr double kStep = 0.01;  // mm
  const double along_x = OrderAt(laser, {kStep, 0, 0}) - OrderAt(laser, {-kStep, 0, 0});
  const double along_y = OrderAt(laser, {0, kStep, 0}) - OrderAt(laser, {0, -kStep, 0});
  EXPECT_NEAR(along_y / along_x, 0.0, 1e-6) << "x is perpendicular to the stripe";
  EXPECT_GT(Project(device.camera, {1, 0, 0}).x(), Project(device.camera, {0, 0, 0}).x()) << "x grows with u";
  EXPECT_GT(device.camera.Center().z(), 100.0);
  EXPECT_NEAR(device.camera.camera_from_world.rotation.determinant(), 1.0, 1e-12);
  for (const VirtualLaser& l : device.lasers) {
    EXPECT_GT(l.fan.a.x(), 0.9) << "orders grow with x";
    EXPECT_NEAR(l.fan.a.cross(l.fan.b).dot(l.fan.n), 1.0, 1e-12);
    EXPECT_LT(l.fan.n.z(), -0.9) << "light goes down";
  }
}

TEST(VirtualDevice, WorldFrameIsTheOneOfTheDesign) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    ExpectWorldFrame(BuildVirtualDevice(DefaultDevice(), seed));
  }
}

TEST(VirtualDevice, WorldFrameHoldsForOneLaserAndForACameraTurnedRound) {
  DeviceDescription one = DefaultDevice();
  one.lasers.resize(1);
  ExpectWorldFrame(BuildVirtualDevice(one, 3));

  const auto two = ReadDeviceDescription("devices/two-lasers-70.toml");
  ASSERT_TRUE(two.ok()) << two.error().message;
  ExpectWorldFrame(BuildVirtualDevice(*two, 3));
}

TEST(VirtualDevice, MountingErrorsDifferBySeedAndRepeat) {
  const VirtualDevice a = BuildVirtualDevice(DefaultDevice(), 7), b = BuildVirtualDevice(DefaultDevice(), 7),
                      c = BuildVirtualDevice(DefaultDevice(), 8);
  EXPECT_EQ(a.camera.fx, b.camera.fx);
  EXPECT_EQ(a.camera.Center(), b.camera.Center());
  EXPECT_EQ(a.lasers[2].fan.origin, b.lasers[2].fan.origin);
  EXPECT_EQ(a.lasers[2].efficiency, b.lasers[2].efficiency);
  EXPECT_NE(a.camera.fx, c.camera.fx);
  EXPECT_GT((a.camera.Center() - c.camera.Center()).norm(), 0.01);
  for (std::size_t k = 0; k < a.lasers.size(); ++k) {
    EXPECT_GT((a.lasers[k].fan.origin - c.lasers[k].fan.origin).norm(), 0.01) << k;
    EXPECT_NE(a.lasers[k].fan.step, c.lasers[k].fan.step) << k;
    EXPECT_NE(a.lasers[k].fan.tilt, c.lasers[k].fan.tilt) << k;
  }
}

TEST(VirtualDevice, WithoutMountingErrorsItIsTheDesign) {
  DeviceDescription d = DefaultDevice();
  d.mounting = {0, 0, 0, 0, 0, 0, 0};
  const VirtualDevice device = BuildVirtualDevice(d, 1);
  EXPECT_EQ(device.camera.fx, d.camera.focal_length_px);
  for (std::size_t k = 0; k < d.lasers.size(); ++k) {
    EXPECT_LT((device.lasers[k].fan.a - Eigen::Vector3d::UnitX()).norm(), 1e-9);
    EXPECT_EQ(device.lasers[k].fan.step, d.grating.Step());
    EXPECT_EQ(device.lasers[k].fan.tilt, 0.0);
    const double distance = (device.lasers[k].fan.origin - device.lasers[0].fan.origin).x();
    EXPECT_NEAR(distance, d.lasers[k].position_mm.x() - d.lasers[0].position_mm.x(), 1e-9);
  }
  EXPECT_NEAR(device.camera.Center().x(), d.camera.position_mm.x(), 1e-9);
  EXPECT_NEAR(device.camera.Center().z(), d.camera.position_mm.z(), 1e-9);
}

TEST(VirtualDevice, AnotherLaserDoesNotChangeTheOthers) {
  DeviceDescription three = DefaultDevice();
  three.lasers.resize(3);
  const VirtualDevice a = BuildVirtualDevice(three, 5), b = BuildVirtualDevice(DefaultDevice(), 5);
  EXPECT_EQ(a.lasers[2].fan.origin, b.lasers[2].fan.origin);
  EXPECT_EQ(a.camera.fx, b.camera.fx);
}

TEST(VirtualDevice, CentralStripeIsWhereTheOrderIsZero) {
  const VirtualDevice device = BuildVirtualDevice(DefaultDevice(), 2);
  for (const VirtualLaser& laser : device.lasers) {
    for (const double z : {0.0, 50.0}) {
      for (const double y : {-70.0, 0.0, 55.0}) {
        const StripePointOnPlane at = CentralStripeAt(laser.fan, z, y);
        EXPECT_NEAR(at.point.y(), y, 1e-9);
        EXPECT_NEAR(at.point.z(), z, 1e-9);
        EXPECT_NEAR(OrderAt(laser, at.point), 0.0, 1e-9);
        EXPECT_NEAR(OrderAt(laser, at.point + 0.01 * at.direction), 0.0, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace dorsum
