// SPDX-License-Identifier: Apache-2.0
#include "calibration/sheet_assignment.h"

#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"

namespace dorsum {
namespace {

void AddSegment(const Camera& camera, const DiffractedFan& fan, int order, double z, int from, int to,
                LaserStripes* stripes) {
  StripeSegment segment;
  segment.first = static_cast<std::int32_t>(stripes->points.size());
  for (int v = from; v < to; ++v) {
    const auto u = SheetColumn(camera, fan, order, v, z);
    if (!u) continue;
    StripePoint p;
    p.u = static_cast<float>(*u);
    p.v = static_cast<float>(v);
    p.sd_px = 0.05F;
    stripes->points.push_back(p);
    ++segment.count;
  }
  stripes->segments.push_back(segment);
}

class SheetAssignment : public ::testing::Test {
 protected:
  std::vector<SheetPoint> Assign(const SheetPicture& picture) const {
    return AssignOrders({picture}, device_.truth, {.tolerance = 0.1});
  }
  BundleFixture device_;
};

TEST_F(SheetAssignment, OrdersArePredictedAcrossGaps) {
  SheetPicture picture{"stripesBg0", "backplane", 0, {0}, {}};
  for (const int order : {-3, -2, 1, 4})
    AddSegment(device_.camera, device_.fans[0], order, 0.0, 100, 400, &picture.stripes);
  const auto points = Assign(picture);
  ASSERT_GT(points.size(), 30U);
  std::map<int, int> seen;
  for (const SheetPoint& p : points) {
    ++seen[p.order];
    EXPECT_EQ(p.plane, 0);
    EXPECT_NEAR(OrderMiss(device_.truth, p), 0.0, 1e-3);
    EXPECT_GE(p.v, 108.0) << "ends may be cut by an edge";
    EXPECT_LT(p.v, 392.0);
    EXPECT_NEAR(p.orders_per_px * 40.0, 1.0, 0.6);
  }
  EXPECT_EQ(seen.size(), 4U);
  for (const int order : {-3, -2, 1, 4}) EXPECT_GT(seen[order], 5);
}

TEST_F(SheetAssignment, ABoxAndTheBackplaneBesideItAreToldApart) {
  SheetPicture picture{"heights/h25.0/stripesHand0", "box 25.0 mm", 0, {2, 0}, {}};
  AddSegment(device_.camera, device_.fans[0], 2, 25.0, 200, 400, &picture.stripes);
  AddSegment(device_.camera, device_.fans[0], 2, 0.0, 420, 560, &picture.stripes);
  bool box = false, backplane = false;
  for (const SheetPoint& p : Assign(picture)) {
    EXPECT_EQ(p.plane, p.v < 410.0 ? 2 : 0);
    EXPECT_EQ(p.order, 2);
    (p.plane == 2 ? box : backplane) = true;
  }
  EXPECT_TRUE(box && backplane);
}

TEST_F(SheetAssignment, WhatFitsNoOrderOrTwoPlanesIsLeftOut) {
  SheetPicture picture{"heights/h25.0/stripesHand0", "box 25.0 mm", 0, {2, 0}, {}};
  // 12 mm is on neither plane.
  AddSegment(device_.camera, device_.fans[0], 0, 12.0, 200, 400, &picture.stripes);
  EXPECT_TRUE(Assign(picture).empty());
  // Two planes whose stripes fall together.
  BundleState same = device_.truth;
  same.planes[2] = {0.05, 0.0, 0.0};
  SheetPicture ambiguous{"heights/h25.0/stripesHand0", "box 25.0 mm", 0, {2, 0}, {}};
  AddSegment(device_.camera, device_.fans[0], 0, 0.0, 200, 400, &ambiguous.stripes);
  EXPECT_TRUE(AssignOrders({ambiguous}, same, {.tolerance = 0.1}).empty());
}

}  // namespace
}  // namespace dorsum
