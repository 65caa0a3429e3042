// SPDX-License-Identifier: Apache-2.0
#include "stripes/smoothing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

double SlantedLine(int row) { return 50.0 + 0.3 * row; }

double RmsFromLine(const LaserStripes& stripes) {
  double square = 0.0;
  for (const StripePoint& p : stripes.points) square += std::pow(p.u - SlantedLine(static_cast<int>(p.v)), 2);
  return std::sqrt(square / static_cast<double>(stripes.points.size()));
}

TEST(SmoothSegments, NoiseShrinksAsTheReportedDeviationSays) {
  LaserStripes stripes;
  Rng rng(5);
  AddStripe(&stripes, 0, 2000, [&](int row) { return SlantedLine(row) + 0.3 * rng.Normal(); });
  const LaserStripes smooth = SmoothSegments(stripes, 8, {});
  ASSERT_EQ(smooth.points.size(), 2000U);
  EXPECT_NEAR(RmsFromLine(stripes), 0.3, 0.02);
  const float sd = smooth.points[1000].sd_px;
  EXPECT_NEAR(sd, 0.3 / std::sqrt(11.0), 1e-4);
  EXPECT_NEAR(RmsFromLine(smooth), sd, 0.015);
  EXPECT_GT(smooth.points.front().sd_px, sd) << "an end has fewer rows around it";
}

TEST(SmoothSegments, ASlantedLineStaysUnbentToItsEnds) {
  LaserStripes stripes;
  AddStripe(&stripes, 10, 60, SlantedLine);
  const LaserStripes smooth = SmoothSegments(stripes, 8, {});
  EXPECT_LT(RmsFromLine(smooth), 1e-4);
  EXPECT_NEAR(smooth.segments[0].min_u, SlantedLine(10), 1e-3);
  EXPECT_NEAR(smooth.segments[0].max_u, SlantedLine(59), 1e-3);
  EXPECT_EQ(smooth.segments[0].min_v, 10.0F);
  EXPECT_EQ(smooth.segments[0].max_v, 59.0F);
}

TEST(SmoothSegments, AJumpPartsTheStripeAndIsNotRoundedOff) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 60, [](int row) { return row < 30 ? 50.0 : 58.0; });
  const LaserStripes smooth = SmoothSegments(stripes, 8, {});
  ASSERT_EQ(smooth.segments.size(), 2U);
  EXPECT_NEAR(smooth.points[29].u, 50.0, 1e-4);
  EXPECT_NEAR(smooth.points[30].u, 58.0, 1e-4);
  EXPECT_EQ(smooth.points[29].segment, 0);
  EXPECT_EQ(smooth.points[30].segment, 1);
}

TEST(SmoothSegments, ARowThatIsMissingPartsTheStripeToo) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 30, 50.0);
  for (std::size_t i = 15; i < 30; ++i) stripes.points[i].v += 3.0F;
  EXPECT_EQ(SmoothSegments(stripes, 8, {}).segments.size(), 2U);
}

TEST(SmoothSegments, PiecesTooShortAreDroppedWithTheirPoints) {
  LaserStripes stripes;
  AddStripe(&stripes, 0, 40, [](int row) { return row < 5 ? 50.0 : 60.0; });
  const LaserStripes smooth = SmoothSegments(stripes, 8, {});
  ASSERT_EQ(smooth.segments.size(), 1U);
  EXPECT_EQ(smooth.segments[0].first, 0);
  EXPECT_EQ(smooth.points.size(), 35U);
}

TEST(SmoothSegments, TopAndBottomNeighboursStayWithinTheirStripe) {
  LaserStripes stripes;
  stripes.laser = 3;
  AddStripe(&stripes, 0, 20, 50.0);
  AddStripe(&stripes, 5, 25, 80.0);
  const LaserStripes smooth = SmoothSegments(stripes, 8, {});
  EXPECT_EQ(smooth.laser, 3);
  for (std::size_t i = 0; i < smooth.points.size(); ++i) {
    const StripePoint& p = smooth.points[i];
    const bool first = i == 0 || i == 20, last = i == 19 || i == 39;
    EXPECT_EQ(p.top, first ? kNoPoint : static_cast<std::int32_t>(i) - 1);
    EXPECT_EQ(p.bottom, last ? kNoPoint : static_cast<std::int32_t>(i) + 1);
  }
}

TEST(SmoothSegments, NoWindowLeavesTheStripeAsItIs) {
  LaserStripes stripes;
  Rng rng(6);
  AddStripe(&stripes, 0, 50, [&](int row) { return SlantedLine(row) + 0.3 * rng.Normal(); });
  const LaserStripes smooth = SmoothSegments(stripes, 8, {.half_window_rows = 0});
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(smooth.points[i].u, stripes.points[i].u);
    EXPECT_EQ(smooth.points[i].sd_px, stripes.points[i].sd_px);
  }
}

}  // namespace
}  // namespace dorsum
