// SPDX-License-Identifier: Apache-2.0
#include "stripes/device_orders.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "stripes/joint_scene_test.h"

namespace dorsum {
namespace {

TEST(DeviceOrders, AreThoseOfTheSheetsInEveryPartOfThePicture) {
  DeviceGeometry device = FanDevice(2);
  device.camera.distortion = {-0.12, 0.05, 1e-3, -1e-3, 0.0};
  const DeviceOrders orders(device);
  double worst_order = 0.0, worst_height = 0.0;
  for (const LaserGeometry& laser : device.lasers) {
    for (double u = -0.5; u < device.camera.width; u += 13.7) {
      for (double v = -0.5; v < device.camera.height; v += 17.3) {
        const auto near = orders.At(laser.laser, u, v);
        ASSERT_TRUE(near) << u << " " << v;
        const Ray ray = CastRay(device.camera, {u, v});
        for (const double z : {-3.0, 0.0, 20.0, 41.0, 77.0}) {
          const auto exact = OrderAtHeight(ray, laser, SheetModel::kCone, z);
          ASSERT_TRUE(exact);
          worst_order = std::max(worst_order, std::abs(near->OrderAt(z) - *exact));
          worst_height = std::max(worst_height, std::abs(near->HeightOf(*exact) - z));
        }
      }
    }
  }
  EXPECT_LT(worst_order, 1e-4);
  EXPECT_LT(worst_height, 1e-3);
}

TEST(DeviceOrders, KnowOnlyTheDevicesLasers) {
  const DeviceOrders orders(FanDevice(1));
  EXPECT_TRUE(orders.At(0, 100.0, 100.0));
  EXPECT_FALSE(orders.At(5, 100.0, 100.0));
}

}  // namespace
}  // namespace dorsum
