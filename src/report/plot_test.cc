// SPDX-License-Identifier: Apache-2.0
#include "report/plot.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/drawing.h"

namespace dorsum {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(Plot, TicksAreRoundAndInsideTheRange) {
  EXPECT_THAT(Ticks({-12.0, 27.0}, 4), ElementsAre(DoubleNear(-10, 1e-9), DoubleNear(0, 1e-9),
                                                   DoubleNear(10, 1e-9), DoubleNear(20, 1e-9)));
  EXPECT_TRUE(Ticks({1.0, 1.0}, 5).empty());
  EXPECT_TRUE(Ticks({std::numeric_limits<double>::quiet_NaN(), 1.0}, 5).empty());
}

TEST(Plot, RoundOutAlwaysGivesAUsableRange) {
  const Range wide = RoundOut({-3.2, 47.0});
  EXPECT_DOUBLE_EQ(wide.low, -10.0);
  EXPECT_DOUBLE_EQ(wide.high, 50.0);
  for (const Range& odd :
       {Range{5.0, 5.0}, Range{3.0, -3.0}, Range{0.0, std::numeric_limits<double>::infinity()}}) {
    EXPECT_GT(RoundOut(odd).Span(), 0.0);
  }
}

TEST(Plot, YGrowsUpwards) {
  const PlotArea area{{10, 20, 100, 200}, {0.0, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(area.ToPixel(0.0, 0.0), cv::Point2d(10.0, 220.0));
  EXPECT_EQ(area.ToPixel(1.0, 1.0), cv::Point2d(110.0, 20.0));
  EXPECT_NEAR(area.YAt(20), 1.0, 0.01);
}

TEST(Drawing, NumbersHaveNoNegativeZero) {
  EXPECT_EQ(FormatNumber(-0.001, 2), "0.00");
  EXPECT_EQ(FormatNumber(-0.01, 2), "-0.01");
  EXPECT_EQ(FormatNumber(std::numeric_limits<double>::quiet_NaN(), 2), "-");
}

TEST(Drawing, TextLeavesInkAlsoUpwardsAndBeyondAscii) {
  cv::Mat canvas(100, 100, CV_8UC3, Pen(kPaper));
  DrawTextUpwards(canvas, "h\xC3\xB6he", {50.0, 50.0}, {.align = Align::kCentre});
  cv::Mat ink;
  cv::extractChannel(canvas, ink, 0);
  EXPECT_LT(cv::countNonZero(ink == 255), 100 * 100 - 50);
  EXPECT_EQ(cv::countNonZero(ink.colRange(60, 100) < 255), 0);
}

TEST(Drawing, FitIntoKeepsTheWholePicture) {
  const cv::Mat picture(10, 40, CV_8UC3, cv::Scalar(0, 0, 255));
  const cv::Mat fitted = FitInto(picture, {100, 100});
  EXPECT_EQ(fitted.size(), cv::Size(100, 100));
  EXPECT_EQ(fitted.at<Colour>(50, 2), Colour(0, 0, 255));
  EXPECT_EQ(fitted.at<Colour>(10, 50), kPaper);
  EXPECT_EQ(FitInto({}, {30, 20}).size(), cv::Size(30, 20));
}

}  // namespace
}  // namespace dorsum
