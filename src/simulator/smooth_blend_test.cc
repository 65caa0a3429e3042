// SPDX-License-Identifier: Apache-2.0
#include "simulator/smooth_blend.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(SmoothBlendTest, FarApartIsThePlainUnion) {
  EXPECT_EQ(SmoothUnion(1.0, 9.0, 5.0), 1.0);
  EXPECT_EQ(SmoothUnion(-3.0, 9.0, 5.0), -3.0);
  EXPECT_EQ(SmoothIntersection(1.0, 9.0, 5.0), 9.0);
}

TEST(SmoothBlendTest, AddsASixthOfTheRadiusAtTheSeam) {
  EXPECT_DOUBLE_EQ(SmoothUnion(2.0, 2.0, 6.0), 1.0);
  EXPECT_DOUBLE_EQ(SmoothIntersection(2.0, 2.0, 6.0), 3.0);
}

TEST(SmoothBlendTest, UnionNeverShrinksAndIntersectionNeverGrows) {
  for (double a = -4; a <= 4; a += 0.25) {
    EXPECT_LE(SmoothUnion(a, 0.3, 4.0), std::min(a, 0.3));
    EXPECT_GE(SmoothIntersection(a, 0.3, 4.0), std::max(a, 0.3));
  }
}

TEST(SmoothBlendTest, SlopeIsContinuousAtTheSeamsEdges) {
  const double h = 1e-6;
  for (double edge : {-3.0, 3.0}) {
    auto slope = [&](double a) {
      return (SmoothUnion(a + h, 0.0, 3.0) - SmoothUnion(a - h, 0.0, 3.0)) / (2 * h);
    };
    EXPECT_NEAR(slope(edge - 1e-3), slope(edge + 1e-3), 1e-3);
  }
  EXPECT_NEAR(SmoothUnion(1e-7, 0.0, 3.0), SmoothUnion(-1e-7, 0.0, 3.0), 1e-6);
}

TEST(SmoothBlendTest, SmoothStepWorksBothWays) {
  EXPECT_EQ(SmoothStep(0, 2, -1), 0);
  EXPECT_EQ(SmoothStep(0, 2, 3), 1);
  EXPECT_EQ(SmoothStep(0, 2, 1), 0.5);
  EXPECT_EQ(SmoothStep(2, 0, 3), 0);
  EXPECT_EQ(SmoothStep(2, 0, -1), 1);
}

}  // namespace
}  // namespace dorsum
