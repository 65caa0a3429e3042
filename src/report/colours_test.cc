// SPDX-License-Identifier: Apache-2.0
#include "report/colours.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

double Luminance(const Colour& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c[2] / 255.0) + 0.7152 * linear(c[1] / 255.0) + 0.0722 * linear(c[0] / 255.0);
}

TEST(Colours, SequentialKeepsTheOrderOfValuesInGreyPrint) {
  double last = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const double now = Luminance(SequentialColour(i / 100.0));
    EXPECT_GT(now, last) << "at " << i << " %";
    last = now;
  }
  EXPECT_LT(Luminance(SequentialColour(0.0)), 0.06);
  EXPECT_GT(Luminance(SequentialColour(1.0)), 0.7);
}

TEST(Colours, OutOfRangeAndNanAreHarmless) {
  EXPECT_EQ(SequentialColour(-5.0), SequentialColour(0.0));
  EXPECT_EQ(SequentialColour(5.0), SequentialColour(1.0));
  EXPECT_EQ(SequentialColour(std::numeric_limits<double>::quiet_NaN()), Colour(128, 128, 128));
}

TEST(Colours, DivergingTellsTheSign) {
  EXPECT_GT(DivergingColour(-1.0)[0], DivergingColour(-1.0)[2]);
  EXPECT_GT(DivergingColour(1.0)[2], DivergingColour(1.0)[0]);
  EXPECT_GT(Luminance(DivergingColour(0.0)), 0.8);
  EXPECT_NEAR(Luminance(DivergingColour(-1.0)), Luminance(DivergingColour(1.0)), 0.06);
}

TEST(Colours, NeighbouringOrdersLookDifferentAndTheCentralOneIsAlone) {
  for (int order = -30; order <= 30; ++order) {
    EXPECT_GT(cv::norm(cv::Vec3d(OrderColour(order)) - cv::Vec3d(OrderColour(order + 1))), 90.0) << order;
    if (order != 0) {
      EXPECT_NE(OrderColour(order), OrderColour(0));
    }
  }
}

}  // namespace
}  // namespace dorsum
