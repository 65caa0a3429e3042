// SPDX-License-Identifier: Apache-2.0
#include "surface/outline.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(OutlineTest, DistancesGrowInwardsFromBetweenThePixels) {
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(20, 10, 30, 40)).setTo(255);  // columns 20 to 49, rows 10 to 49
  const Outline outline(mask, 6);
  EXPECT_NEAR(outline.Distance(20.0, 30.0), 0.5, 1e-6);
  EXPECT_NEAR(outline.Distance(19.5, 30.0), 0.0, 1e-6);
  EXPECT_NEAR(outline.Distance(25.25, 30.0), 5.75, 1e-6);
  EXPECT_NEAR(outline.Distance(17.0, 30.0), -2.5, 1e-6);
  EXPECT_LE(outline.Distance(2.0, 2.0), -5.0F);
  EXPECT_EQ(outline.bounds(), cv::Rect(14, 4, 42, 52));
}

TEST(OutlineTest, TheImagesBorderIsNoOutline) {
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(0, 20, 40, 20)).setTo(255);
  const Outline outline(mask, 5);
  EXPECT_NEAR(outline.Distance(0.0, 30.0), 9.5, 1e-6);  // to the row below, not to the border
  const Outline full(cv::Mat(60, 80, CV_8UC1, cv::Scalar(1)), 5);
  EXPECT_GT(full.Distance(0.0, 0.0), 100.0F);
}

TEST(OutlineTest, NothingIsInsideAnEmptyMask) {
  const Outline outline(cv::Mat(60, 80, CV_8UC1, cv::Scalar(0)), 5);
  EXPECT_LT(outline.Distance(40.0, 30.0), 0.0F);
}

}  // namespace
}  // namespace dorsum
