// SPDX-License-Identifier: Apache-2.0
#include "stripes/object_stripes.h"

#include <gtest/gtest.h>

#include "stripes/joint_scene_test.h"

namespace dorsum {
namespace {

// One stripe of order 1 whose height is given for every row.
IndexedStripes Stripe(
    const DeviceGeometry& device, const std::function<double(int row)>& height,
    const std::function<float(int row)>& width = [](int) { return 2.0F; }) {
  LaserStripes one;
  AddStripe(&one, 100, 400,
            [&](int row) { return *ColumnOf(device, device.lasers[0], 1, row, height(row)); });
  for (StripePoint& p : one.points) p.width = width(static_cast<int>(p.v));
  one.segments[0].order = 1;
  IndexedStripes stripes;
  stripes.diagnostics.emplace_back();
  stripes.lasers.push_back(one);
  return stripes;
}

TEST(ObjectStripes, PartAStripeWhereItClimbsOffTheBackplane) {
  const DeviceGeometry device = FanDevice(1);
  const ObjectSplit split =
      SplitByHeight(Stripe(device, [](int row) { return row < 250 ? 0.0 : 0.5 * (row - 250); }), {},
                    DeviceOrders(device), {});
  ASSERT_EQ(split.object.lasers[0].segments.size(), 1U);
  EXPECT_EQ(split.object.lasers[0].segments[0].order, 1);
  EXPECT_NEAR(split.object.lasers[0].segments[0].min_v, 252.0, 1.0);
  EXPECT_EQ(split.object.lasers[0].segments[0].max_v, 399.0);
  EXPECT_EQ(split.object.lasers[0].points.size() + split.backplane.size(), 300U);
}

TEST(ObjectStripes, LeaveAnEdgesLightOnTheBackplane) {
  const DeviceGeometry device = FanDevice(1);
  const ObjectSplit split = SplitByHeight(Stripe(device, [](int row) { return row > 390 ? 1.5 : 0.0; }), {},
                                          DeviceOrders(device), {});
  EXPECT_TRUE(split.object.lasers[0].points.empty());
  EXPECT_EQ(split.backplane.size(), 300U);
}

TEST(ObjectStripes, KeepAThinSheetThatIsLong) {
  const DeviceGeometry device = FanDevice(1);
  const ObjectSplit split = SplitByHeight(Stripe(device, [](int row) { return row > 250 ? 1.5 : 0.0; }), {},
                                          DeviceOrders(device), {});
  EXPECT_EQ(split.object.lasers[0].points.size(), 149U);
}

TEST(ObjectStripes, RaiseTheThresholdWithTheBackplanesNoise) {
  const DeviceGeometry device = FanDevice(1);
  const ObjectSplit split = SplitByHeight(Stripe(device, [](int row) { return row % 2 == 0 ? 0.3 : -0.3; }),
                                          {}, DeviceOrders(device), {});
  EXPECT_NEAR(split.backplane_sd_mm, 0.445, 0.02);
  EXPECT_GT(split.threshold_mm, 2.0);
}

TEST(ObjectStripes, DropTheBroadEdgeOfAShadow) {
  const DeviceGeometry device = FanDevice(1);
  const ObjectSplit split = SplitByHeight(Stripe(
                                              device, [](int row) { return row < 300 ? 0.0 : 10.0; },
                                              [](int row) { return row < 300 ? 2.0F : 8.0F; }),
                                          {}, DeviceOrders(device), {});
  EXPECT_TRUE(split.object.lasers[0].points.empty());
  EXPECT_NEAR(split.wide, 100, 4);
}

TEST(ObjectStripes, HoldNothingWithoutAnOrder) {
  const DeviceGeometry device = FanDevice(1);
  IndexedStripes stripes = Stripe(device, [](int) { return 20.0; });
  stripes.lasers[0].segments[0].order.reset();
  const ObjectSplit split = SplitByHeight(stripes, {}, DeviceOrders(device), {});
  EXPECT_TRUE(split.object.lasers[0].points.empty());
  EXPECT_TRUE(split.backplane.empty());
}

}  // namespace
}  // namespace dorsum
