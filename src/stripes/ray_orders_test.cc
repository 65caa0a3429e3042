// SPDX-License-Identifier: Apache-2.0
#include "stripes/ray_orders.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"
#include "stripes/joint_scene_test.h"

namespace dorsum {
namespace {

constexpr double kLow = -3.0, kHigh = 83.0;

RayOrders::Nodes NodesOf(const DeviceGeometry& device) { return {device.camera.Center().z(), kLow, kHigh}; }

RayOrders Along(const RayOrders::Nodes& nodes, const DeviceGeometry& device, double u, double v) {
  return {nodes, nodes.Differences(nodes.Sample(device.camera, device.lasers[0], u, v).value())};
}

// Orders whose sheets the ray meets between the heights.
std::pair<int, int> Seen(const RayOrders& ray) {
  const auto [low, high] = std::minmax({ray.OrderAt(kLow), ray.OrderAt(kHigh)});
  return {static_cast<int>(std::ceil(low)), static_cast<int>(std::floor(high))};
}

TEST(RayOrders, GivesTheHeightsThatTheSheetsGive) {
  const DeviceGeometry device = FanDevice(1);
  const RayOrders::Nodes nodes = NodesOf(device);
  for (const double u : {50.0, 400.0, 750.0}) {
    for (const double v : {20.0, 300.0, 580.0}) {
      const RayOrders ray = Along(nodes, device, u, v);
      const auto [first, last] = Seen(ray);
      for (int m = first; m <= last; ++m) {
        const auto p = IntersectSheet(CastRay(device.camera, {u, v}), device.lasers[0], SheetModel::kCone, m);
        ASSERT_TRUE(p);
        EXPECT_NEAR(ray.HeightOf(m), p->z(), 1e-3) << u << " " << v << " " << m;
      }
    }
  }
}

TEST(RayOrders, TakesPlanesWhereThereIsNoFan) {
  const DeviceGeometry device = TestDevice();
  const RayOrders::Nodes nodes = NodesOf(device);
  const RayOrders ray = Along(nodes, device, 300.0, 200.0);
  const int m = Seen(ray).first;
  const auto p =
      IntersectSheet(CastRay(device.camera, {300.0, 200.0}), device.lasers[0], SheetModel::kPlane, m);
  ASSERT_TRUE(p);
  EXPECT_NEAR(ray.HeightOf(m), p->z(), 0.1);
}

TEST(RayOrders, NothingIsSampledWhereNoSheetIs) {
  LaserGeometry nothing;
  const DeviceGeometry device = TestDevice();
  EXPECT_FALSE(NodesOf(device).Sample(device.camera, nothing, 300.0, 200.0));
}

}  // namespace
}  // namespace dorsum
