// SPDX-License-Identifier: Apache-2.0
#include "imaging/shadow.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

cv::Mat Mask() {
  cv::Mat mask = cv::Mat::zeros(40, 100, CV_8UC1);
  mask.colRange(20, 80).setTo(255);
  return mask;
}

std::vector<cv::Point> Column(int u) {
  std::vector<cv::Point> places;
  places.reserve(40);
  for (int v = 0; v < 40; ++v) places.emplace_back(u, v);
  return places;
}

TEST(RemoveShadow, TheBorderLiesMidwayBetweenObjectAndBackplane) {
  const cv::Mat out = RemoveShadow(Mask(), Column(40), Column(70));
  EXPECT_EQ(cv::countNonZero(out.colRange(20, 55)), 35 * 40);
  EXPECT_EQ(cv::countNonZero(out.colRange(57, 100)), 0);
  EXPECT_EQ(cv::countNonZero(out.colRange(0, 20)), 0);
}

TEST(RemoveShadow, PlacesOutsideTheMaskDoNotCount) {
  const cv::Mat out = RemoveShadow(Mask(), Column(40), Column(90));
  EXPECT_EQ(cv::norm(out, Mask(), cv::NORM_INF), 0.0);
  const cv::Mat far = RemoveShadow(Mask(), Column(40), {{-5, 3}, {500, 3}, {30, 400}});
  EXPECT_EQ(cv::norm(far, Mask(), cv::NORM_INF), 0.0);
}

TEST(RemoveShadow, WithoutPlacesTheMaskStaysAndIsACopy) {
  const cv::Mat mask = Mask();
  cv::Mat out = RemoveShadow(mask, Column(40), {});
  EXPECT_EQ(cv::norm(out, mask, cv::NORM_INF), 0.0);
  out.setTo(0);
  EXPECT_GT(cv::countNonZero(mask), 0);
  EXPECT_EQ(cv::norm(RemoveShadow(mask, {}, Column(40)), mask, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace dorsum
