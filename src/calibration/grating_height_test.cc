// SPDX-License-Identifier: Apache-2.0
#include "calibration/grating_height.h"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

using ::testing::HasSubstr;

// Stripes of orders from..to, whose spacing grows outwards, scaled as a plane `height` below a grating at 300
// mm.
PlaneStripes Stripes(int from, int to, double height, const std::vector<int>& missing = {}) {
  PlaneStripes s;
  for (int m = from; m <= to; ++m) {
    if (std::find(missing.begin(), missing.end(), m) != missing.end()) continue;
    if (m == 0) s.central = static_cast<int>(s.x_mm.size());
    s.x_mm.push_back((8.0 * m + 0.02 * m * m * m) * (300.0 - height) / 300.0 + 5.0);
    s.index.push_back(m - from);
  }
  return s;
}

TEST(GratingHeight, Equation34IsExactForStripesOfTheSameOrders) {
  const auto g = EstimateGratingHeight(Stripes(-6, 6, 0.0), Stripes(-6, 6, 40.0), 40.0, 1);
  ASSERT_TRUE(g.ok());
  EXPECT_NEAR(g->height_mm, 300.0, 1e-9);
  EXPECT_EQ(g->from_order, -6);
  EXPECT_EQ(g->to_order, 6);
  EXPECT_NEAR(g->spacing_closer_mm / g->spacing_further_mm, 260.0 / 300.0, 1e-12);
}

TEST(GratingHeight, OrdersThatOnlyOneDistanceShowsDoNotBiasIt) {
  // The spacing grows outwards, so plain means over all stripes would not compare.
  const auto g = EstimateGratingHeight(Stripes(-9, 4, 0.0, {2}), Stripes(-5, 8, 40.0, {-1}), 40.0, 1);
  ASSERT_TRUE(g.ok());
  EXPECT_NEAR(g->height_mm, 300.0, 1e-9);
  EXPECT_EQ(g->from_order, -5);
  EXPECT_EQ(g->to_order, 4);
}

TEST(GratingHeight, SwappedImagesAreNamed) {
  const auto g = EstimateGratingHeight(Stripes(-6, 6, 40.0), Stripes(-6, 6, 0.0), 40.0, 2);
  ASSERT_FALSE(g.ok());
  EXPECT_EQ(g.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(g.error().message, HasSubstr("laser 2"));
  EXPECT_THAT(g.error().message, HasSubstr("swapped"));
  EXPECT_FALSE(EstimateGratingHeight(Stripes(-6, 6, 0.0), Stripes(-6, 6, 0.0), 40.0, 2).ok());
}

TEST(GratingHeight, TooFewCommonStripesAreNamed) {
  const auto g = EstimateGratingHeight(Stripes(-6, 1, 0.0), Stripes(0, 6, 40.0), 40.0, 3);
  ASSERT_FALSE(g.ok());
  EXPECT_THAT(g.error().message, HasSubstr("laser3CalFurther"));
}

}  // namespace
}  // namespace dorsum
