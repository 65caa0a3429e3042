// SPDX-License-Identifier: Apache-2.0
#include "stripes/ray_orders.h"

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"
#include "stripes/joint_scene_test.h"

namespace dorsum {
namespace {

TEST(RayOrders, GivesTheHeightsThatTheSheetsGive) {
  const DeviceGeometry device = FanDevice(1);
  const LaserGeometry& laser = device.lasers[0];
  for (const double u : {50.0, 400.0, 750.0}) {
    for (const double v : {20.0, 300.0, 580.0}) {
      const RayOrders ray(device.camera, laser, u, v, -3.0, 83.0);
      ASSERT_TRUE(ray.valid());
      const auto [low, high] = std::pair(std::min(ray.OrderAtLow(), ray.OrderAtHigh()),
                                         std::max(ray.OrderAtLow(), ray.OrderAtHigh()));
      for (int m = static_cast<int>(std::ceil(low)); m <= high; ++m) {
        const auto p = IntersectSheet(CastRay(device.camera, {u, v}), laser, SheetModel::kCone, m);
        ASSERT_TRUE(p);
        EXPECT_NEAR(ray.HeightOf(m), p->z(), 0.02) << u << " " << v << " " << m;
      }
    }
  }
}

TEST(RayOrders, TakesPlanesWhereThereIsNoFan) {
  const DeviceGeometry device = TestDevice();
  const RayOrders ray(device.camera, device.lasers[0], 300.0, 200.0, 0.0, 80.0);
  ASSERT_TRUE(ray.valid());
  const int m = static_cast<int>(std::ceil(std::min(ray.OrderAtLow(), ray.OrderAtHigh())));
  const auto p =
      IntersectSheet(CastRay(device.camera, {300.0, 200.0}), device.lasers[0], SheetModel::kPlane, m);
  ASSERT_TRUE(p);
  EXPECT_NEAR(ray.HeightOf(m), p->z(), 0.1);
}

}  // namespace
}  // namespace dorsum
