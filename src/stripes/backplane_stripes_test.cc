// SPDX-License-Identifier: Apache-2.0
#include "stripes/backplane_stripes.h"

#include <gtest/gtest.h>

#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

// The empty backplane shows laser 0's stripes every 40 px from column 50 on, with green value 100.
class BackplaneStripesTest : public ::testing::Test {
 protected:
  BackplaneStripesTest() {
    LaserGeometry laser;
    for (int m = 0; m < 8; ++m) {
      ReferenceStripe r;
      r.order = m;
      r.middle_v = 100.0;
      r.half_v = 100.0;
      r.u = {50.0 + 40.0 * m, 0.0, 0.0, 0.0};
      r.peak = {100.0, 0.0, 0.0};
      laser.reference.push_back(r);
    }
    device_.lasers.push_back(laser);
  }
  BackplaneSplit Split() { return SplitBackplane({stripes_}, device_, 8, {}).at(0); }
  DeviceGeometry device_;
  LaserStripes stripes_;
};

TEST_F(BackplaneStripesTest, AStripeOnItsReferenceAndAsBrightIsTakenOut) {
  AddStripe(&stripes_, 20, 120, 90.3, 95.0);
  AddStripe(&stripes_, 20, 120, 110.0, 95.0);
  const BackplaneSplit split = Split();
  EXPECT_EQ(split.backplane.size(), 100U);
  ASSERT_EQ(split.object.segments.size(), 1U);
  EXPECT_EQ(split.object.points[0].u, 110.0F);
  EXPECT_EQ(split.object.points[0].segment, 0);
  EXPECT_EQ(split.object.points[0].top, kNoPoint);
  EXPECT_EQ(split.object.points[0].bottom, 1);
}

TEST_F(BackplaneStripesTest, ADimOrAMuchBrighterStripeThereIsTheObjects) {
  AddStripe(&stripes_, 20, 120, 90.0, 40.0);
  AddStripe(&stripes_, 20, 120, 170.0, 220.0);
  const BackplaneSplit split = Split();
  EXPECT_TRUE(split.backplane.empty());
  EXPECT_EQ(split.object.segments.size(), 2U);
}

TEST_F(BackplaneStripesTest, ABrightStripeThereByChanceIsOutvotedByItsDimNeighbours) {
  // The object's height shifts stripes by one whole spacing: all meet references, one is as bright as there.
  AddStripe(&stripes_, 20, 120, 50.0, 45.0);
  AddStripe(&stripes_, 20, 120, 90.0, 100.0);
  AddStripe(&stripes_, 20, 120, 130.0, 45.0);
  const BackplaneSplit split = Split();
  EXPECT_TRUE(split.backplane.empty());
  EXPECT_EQ(split.object.points.size(), 300U);
}

TEST_F(BackplaneStripesTest, AStripeThatLeavesTheBackplaneIsParted) {
  AddStripe(&stripes_, 20, 120, [](int row) { return row < 60 ? 90.0 : 100.0; });
  const BackplaneSplit split = Split();
  EXPECT_EQ(split.backplane.size(), 40U);
  ASSERT_EQ(split.object.segments.size(), 1U);
  EXPECT_EQ(split.object.segments[0].count, 60);
  EXPECT_EQ(split.object.segments[0].min_v, 60.0F);
}

TEST_F(BackplaneStripesTest, ASpeckledRowDoesNotPartAStripeOnTheBackplane) {
  AddStripe(&stripes_, 20, 120, 90.0, 100.0);
  for (std::size_t i = 0; i < 5; ++i) stripes_.points[i].peak = 30.0F;  // a dim end
  stripes_.points[50].u += 2.0F;
  const BackplaneSplit split = Split();
  EXPECT_EQ(split.backplane.size(), 100U);
  EXPECT_TRUE(split.object.points.empty());
}

TEST_F(BackplaneStripesTest, PiecesTooShortAreDropped) {
  AddStripe(&stripes_, 20, 64, [](int row) { return row < 60 ? 90.0 : 100.0; });
  EXPECT_TRUE(Split().object.segments.empty());
}

TEST_F(BackplaneStripesTest, RowsBeyondTheReferenceAreTheObjects) {
  AddStripe(&stripes_, 210, 260, 90.0, 100.0);
  EXPECT_EQ(Split().object.points.size(), 50U);
}

TEST_F(BackplaneStripesTest, AnUnknownLaserOrNoStripesAreLeftAsTheyAre) {
  EXPECT_TRUE(Split().object.points.empty());
  AddStripe(&stripes_, 20, 120, 90.0, 100.0);
  stripes_.laser = 4;
  const BackplaneSplit split = Split();
  EXPECT_EQ(split.object.laser, 4);
  EXPECT_EQ(split.object.points.size(), 100U);
}

}  // namespace
}  // namespace dorsum
