// SPDX-License-Identifier: Apache-2.0
#include "stripes/classic_segments.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

class ClassicSegmentsTest : public ::testing::Test {
 protected:
  // A region of 4 columns, its left edge at `u`.
  void Draw(int u, int from, int to) { mask_(cv::Rect(u, from, 4, to - from)).setTo(255); }
  LaserStripes Extract(const ClassicSegmentOptions& options = {}) {
    return ExtractClassicSegments(mask_, green_, 2, options);
  }
  cv::Mat mask_ = cv::Mat::zeros(60, 100, CV_8UC1);
  cv::Mat green_ = cv::Mat(60, 100, CV_8UC1, cv::Scalar(50));
};

TEST_F(ClassicSegmentsTest, StripesComeInTheOrderOfTheirColumns) {
  Draw(70, 0, 60);
  Draw(10, 30, 60);
  Draw(40, 5, 50);
  const LaserStripes stripes = Extract();
  EXPECT_EQ(stripes.laser, 2);
  ASSERT_EQ(stripes.segments.size(), 3U);
  EXPECT_EQ(stripes.points[static_cast<std::size_t>(stripes.segments[0].first)].u, 10.0F);
  EXPECT_EQ(stripes.points[static_cast<std::size_t>(stripes.segments[1].first)].u, 40.0F);
  EXPECT_EQ(stripes.points[static_cast<std::size_t>(stripes.segments[2].first)].u, 70.0F);
}

TEST_F(ClassicSegmentsTest, EachRowGivesOnePointOnTheLeftBoundary) {
  for (int v = 10; v < 50; ++v) mask_(cv::Rect(20 + v / 5, v, 5, 1)).setTo(255);
  mask_.at<std::uint8_t>(30, 27) = 0;  // a hole makes no second point
  const LaserStripes stripes = Extract();
  ASSERT_EQ(stripes.segments.size(), 1U);
  EXPECT_EQ(stripes.segments[0].count, 40);
  ASSERT_EQ(stripes.points.size(), 40U);
  for (int i = 0; i < 40; ++i) {
    const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
    EXPECT_EQ(p.v, static_cast<float>(10 + i));
    const int column = 20 + (10 + i) / 5;
    EXPECT_EQ(p.u, static_cast<float>(column));
    EXPECT_EQ(p.segment, 0);
    EXPECT_GT(p.sd_px, 0.0F);
  }
}

TEST_F(ClassicSegmentsTest, SmallAndShortRegionsAreNoStripes) {
  Draw(10, 0, 60);
  Draw(30, 20, 25);                           // 5 rows
  mask_(cv::Rect(50, 20, 1, 12)).setTo(255);  // 12 px
  mask_(cv::Rect(70, 20, 20, 5)).setTo(255);  // large but flat
  EXPECT_EQ(Extract().segments.size(), 1U);
  EXPECT_EQ(Extract({.min_area_px = 1, .min_rows = 1}).segments.size(), 4U);
}

TEST_F(ClassicSegmentsTest, BrightnessIsTheCrestsAndNotTheBoundarys) {
  Draw(40, 0, 60);
  green_.col(38).setTo(200);
  green_.col(30).setTo(255);  // another stripe's crest is too far away
  const LaserStripes stripes = Extract();
  ASSERT_EQ(stripes.segments.size(), 1U);
  EXPECT_EQ(stripes.points[0].peak, 200.0F);
  EXPECT_FLOAT_EQ(stripes.segments[0].mean_peak, 200.0F);
}

TEST_F(ClassicSegmentsTest, RegionsAtTheImagesEdgesAreRead) {
  Draw(0, 0, 60);
  Draw(96, 0, 60);
  EXPECT_EQ(Extract().points.size(), 120U);
}

TEST_F(ClassicSegmentsTest, AnEmptyMaskGivesNothing) {
  const LaserStripes stripes = Extract();
  EXPECT_TRUE(stripes.points.empty());
  EXPECT_TRUE(stripes.segments.empty());
}

}  // namespace
}  // namespace dorsum
