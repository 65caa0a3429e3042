// SPDX-License-Identifier: Apache-2.0
#include "surface/gathered_rows.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

constexpr float kLeastSigma = 0.001F;  // mm

SurfacePoint Row(float v, float z, float sigma = 0.1F) {
  SurfacePoint p;
  p.u = 100.0F + v;
  p.v = v;
  p.position = {0.0, 0.0, static_cast<double>(z)};
  p.sigma = sigma;
  return p;
}

GatheredRows Gather(const SurfacePoints& points, int most) {
  return GatherRows(points, std::vector<bool>(points.size(), false), most, kLeastSigma);
}

TEST(GatheredRowsTest, NeighboursBecomeTheirWeightedMean) {
  const GatheredRows out = Gather({Row(10, 5.0F, 0.1F), Row(11, 5.2F, 0.2F)}, 3);
  ASSERT_EQ(out.samples.size(), 1U);
  EXPECT_NEAR(out.samples[0].weight, 125.0, 1e-3);  // 1 / 0.01 + 1 / 0.04
  EXPECT_NEAR(out.samples[0].v, 10.2, 1e-5);
  EXPECT_NEAR(out.samples[0].u, 110.2, 1e-4);
  EXPECT_NEAR(out.samples[0].z, 5.04, 1e-5);
}

TEST(GatheredRowsTest, AtMostAsManyAsAskedFor) {
  SurfacePoints points;
  for (int v = 0; v < 8; ++v) points.push_back(Row(static_cast<float>(v), 5.0F));
  EXPECT_EQ(Gather(points, 3).samples.size(), 3U);
  EXPECT_EQ(Gather(points, 1).samples.size(), 8U);
  EXPECT_EQ(Gather({}, 3).samples.size(), 0U);
}

TEST(GatheredRowsTest, AGapAnotherSegmentAndAnotherLaserPartThem) {
  EXPECT_EQ(Gather({Row(10, 5.0F), Row(12, 5.0F)}, 3).samples.size(), 2U);
  SurfacePoint other = Row(11, 5.0F);
  other.segment = 1;
  EXPECT_EQ(Gather({Row(10, 5.0F), other}, 3).samples.size(), 2U);
  other = Row(11, 5.0F);
  other.laser = 1;
  const GatheredRows out = Gather({Row(10, 5.0F), other}, 3);
  ASSERT_EQ(out.samples.size(), 2U);
  EXPECT_EQ(out.lasers, (std::vector<std::uint8_t>{0, 1}));
}

// A step in height stays one, whichever way the rows run.
TEST(GatheredRowsTest, HeightsThatDisagreeStayApart) {
  EXPECT_EQ(Gather({Row(10, 5.0F), Row(11, 5.5F)}, 3).samples.size(), 1U);
  EXPECT_EQ(Gather({Row(10, 5.0F), Row(11, 5.7F)}, 3).samples.size(), 2U);
  EXPECT_EQ(Gather({Row(11, 5.7F), Row(10, 5.0F)}, 3).samples.size(), 2U);
}

TEST(GatheredRowsTest, WhatIsLeftOutStaysAloneWithoutWeight) {
  const GatheredRows out =
      GatherRows({Row(10, 5.0F), Row(11, 5.0F), Row(12, 5.0F)}, {false, true, false}, 3, kLeastSigma);
  ASSERT_EQ(out.samples.size(), 3U);
  EXPECT_EQ(out.samples[1].weight, 0.0F);
  EXPECT_EQ(out.pooled[1].weight, 0.0F);
  EXPECT_GT(out.samples[0].weight, 0.0F);
  EXPECT_GT(out.samples[2].weight, 0.0F);
}

TEST(GatheredRowsTest, PooledHeightsAreGatheredBesideThoseOfTheRows) {
  SurfacePoint a = Row(10, 5.0F, 0.1F), b = Row(11, 5.1F, 0.1F);
  a.row_z = 5.2F;
  b.row_z = 5.0F;
  a.row_sigma = b.row_sigma = 0.2F;
  const GatheredRows out = Gather({a, b}, 3);
  ASSERT_EQ(out.samples.size(), 1U);
  EXPECT_NEAR(out.samples[0].z, 5.1, 1e-5);
  EXPECT_NEAR(out.samples[0].weight, 50.0, 1e-3);
  EXPECT_NEAR(out.pooled[0].change_mm, -0.05, 1e-5);
  EXPECT_NEAR(out.pooled[0].weight, 200.0, 1e-2);
}

TEST(GatheredRowsTest, NoRowCountsAsBetterThanTheLeastSigma) {
  const GatheredRows out = GatherRows({Row(10, 5.0F, 1e-6F)}, std::vector<bool>(1, false), 1, 0.01F);
  EXPECT_NEAR(out.samples[0].weight, 1e4, 1.0);
}

}  // namespace
}  // namespace dorsum
