// SPDX-License-Identifier: Apache-2.0
#include "stripes/append_segment.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

std::vector<StripePoint> Column(int rows) {
  std::vector<StripePoint> points;
  for (int v = 0; v < rows; ++v) {
    StripePoint p;
    p.u = 10.0F + static_cast<float>(v);
    p.v = static_cast<float>(v);
    p.peak = 100.0F + static_cast<float>(v);
    p.left = 7;
    points.push_back(p);
  }
  return points;
}

TEST(AppendSegmentTest, LinksPointsAndMeasuresTheSegment) {
  LaserStripes stripes;
  AppendSegment(Column(2), std::nullopt, &stripes);
  AppendSegment(Column(5), 3, &stripes);
  AppendSegment({}, 4, &stripes);
  ASSERT_EQ(stripes.segments.size(), 2U);
  const StripeSegment& s = stripes.segments[1];
  EXPECT_EQ(s.first, 2);
  EXPECT_EQ(s.count, 5);
  EXPECT_EQ(s.order, 3);
  EXPECT_FLOAT_EQ(s.max_u, 14.0F);
  EXPECT_FLOAT_EQ(s.max_v, 4.0F);
  EXPECT_FLOAT_EQ(s.mean_peak, 102.0F);
  EXPECT_EQ(stripes.points[2].top, kNoPoint);
  EXPECT_EQ(stripes.points[3].top, 2);
  EXPECT_EQ(stripes.points[6].bottom, kNoPoint);
  EXPECT_EQ(stripes.points[4].segment, 1);
}

TEST(AppendSegmentTest, KeepingPointsPartsSegmentsAndKeepsTheirOrder) {
  LaserStripes stripes;
  stripes.laser = 2;
  AppendSegment(Column(6), -4, &stripes);
  const LaserStripes kept = KeepPoints(stripes, std::vector<char>{0, 1, 1, 0, 0, 1});
  EXPECT_EQ(kept.laser, 2);
  ASSERT_EQ(kept.segments.size(), 2U);
  EXPECT_EQ(kept.segments[0].count, 2);
  EXPECT_EQ(kept.segments[1].count, 1);
  EXPECT_EQ(kept.segments[1].order, -4);
  EXPECT_FLOAT_EQ(kept.points[2].v, 5.0F);
  EXPECT_EQ(kept.points[0].left, kNoPoint);
  EXPECT_THROW(KeepPoints(stripes, std::vector<char>{1}), std::logic_error);
}

}  // namespace
}  // namespace dorsum
