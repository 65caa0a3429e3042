// SPDX-License-Identifier: Apache-2.0
#include "stripes/segment_linking.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

using Rows = std::vector<std::vector<StripePoint>>;

void AddCurve(Rows* rows, int from, int to, const std::function<double(int)>& u, float peak = 50.0F) {
  for (int v = from; v < to; ++v) {
    StripePoint p;
    p.u = static_cast<float>(u(v));
    p.v = static_cast<float>(v);
    p.peak = peak;
    p.width = 2.0F;
    std::vector<StripePoint>& row = (*rows)[static_cast<std::size_t>(v)];
    row.insert(std::upper_bound(row.begin(), row.end(), p,
                                [](const StripePoint& a, const StripePoint& b) { return a.u < b.u; }),
               p);
  }
}

TEST(SegmentLinking, FollowsSteepStripesAndKeepsCloseOnesApart) {
  Rows rows(60);
  AddCurve(&rows, 0, 60, [](int v) { return 20.0 + 1.2 * v; });
  AddCurve(&rows, 0, 60, [](int v) { return 28.0 + 1.2 * v; });
  const LaserStripes stripes = LinkSegments(rows, 3, {});
  EXPECT_EQ(stripes.laser, 3);
  ASSERT_EQ(stripes.segments.size(), 2U);
  for (const StripeSegment& s : stripes.segments) {
    EXPECT_EQ(s.count, 60);
    EXPECT_NEAR(s.max_u - s.min_u, 1.2 * 59, 1e-3);
  }
}

TEST(SegmentLinking, BridgesShortGapsOnly) {
  Rows rows(60);
  AddCurve(&rows, 0, 60, [](int) { return 30.0; });
  rows[20].clear();
  rows[21].clear();
  for (std::size_t v = 40; v < 43; ++v) rows[v].clear();
  const LaserStripes stripes = LinkSegments(rows, 0, {});
  ASSERT_EQ(stripes.segments.size(), 2U);
  EXPECT_EQ(stripes.segments[0].count, 38);
  EXPECT_EQ(stripes.segments[1].count, 17);
}

TEST(SegmentLinking, BreaksWhereTheStripeJumpsOrItsBrightnessDoes) {
  Rows rows(90);
  AddCurve(&rows, 0, 30, [](int) { return 30.0; });
  AddCurve(&rows, 30, 60, [](int) { return 36.0; });
  AddCurve(
      &rows, 60, 90, [](int) { return 36.2; }, 220.0F);
  const LaserStripes stripes = LinkSegments(rows, 0, {});
  ASSERT_EQ(stripes.segments.size(), 3U);
  for (const StripeSegment& s : stripes.segments) EXPECT_EQ(s.count, 30);
}

TEST(SegmentLinking, DropsShortOnesAndNamesNeighboursAlong) {
  Rows rows(40);
  AddCurve(&rows, 0, 5, [](int) { return 10.0; });
  AddCurve(&rows, 10, 20, [](int) { return 20.0; });
  const LaserStripes stripes = LinkSegments(rows, 0, {});
  ASSERT_EQ(stripes.segments.size(), 1U);
  ASSERT_EQ(stripes.points.size(), 10U);
  EXPECT_EQ(stripes.points[0].top, kNoPoint);
  EXPECT_EQ(stripes.points[0].bottom, 1);
  EXPECT_EQ(stripes.points[9].top, 8);
  EXPECT_EQ(stripes.points[9].bottom, kNoPoint);
  EXPECT_FLOAT_EQ(stripes.segments[0].min_v, 10.0F);
  EXPECT_FLOAT_EQ(stripes.segments[0].max_v, 19.0F);
}

}  // namespace
}  // namespace dorsum
