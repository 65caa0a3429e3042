// SPDX-License-Identifier: Apache-2.0
#include "imaging/candidate_region.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

cv::Mat Paper() { return {300, 400, CV_8UC3, cv::Scalar(15, 160, 12)}; }

TEST(CandidateRegion, HoldsTheObjectAndItsMargin) {
  cv::Mat hand = Paper();
  cv::rectangle(hand, {0, 100}, {150, 180}, cv::Scalar(6, 60, 5), cv::FILLED);
  const cv::Mat region = CandidateRegion(Paper(), hand, {.margin_px = 40});
  EXPECT_EQ(cv::countNonZero(region(cv::Rect(0, 65, 151, 151)) == 0), 0);
  EXPECT_EQ(cv::countNonZero(region(cv::Rect(0, 100, 186, 81)) == 0), 0);
  EXPECT_EQ(cv::countNonZero(region.colRange(210, 400)), 0);
  EXPECT_EQ(region.size(), hand.size());
}

TEST(CandidateRegion, SpecksDoNotEnlargeIt) {
  cv::Mat hand = Paper();
  cv::rectangle(hand, {0, 100}, {150, 180}, cv::Scalar(6, 60, 5), cv::FILLED);
  cv::rectangle(hand, {350, 20}, {356, 26}, cv::Scalar(6, 60, 5), cv::FILLED);
  EXPECT_EQ(cv::countNonZero(CandidateRegion(Paper(), hand, {}).colRange(260, 400)), 0);
}

TEST(CandidateRegion, IsTheWholeImageWhenOnlyTheShadowOfAWhiteObjectIsSeen) {
  cv::Mat hand = Paper();
  cv::rectangle(hand, {100, 90}, {250, 100}, cv::Scalar(6, 60, 5), cv::FILLED);
  cv::rectangle(hand, {100, 90}, {110, 190}, cv::Scalar(6, 60, 5), cv::FILLED);
  EXPECT_EQ(cv::countNonZero(CandidateRegion(Paper(), hand, {}) == 0), 0);
}

TEST(CandidateRegion, IsTheWholeImageWhenNothingChanged) {
  EXPECT_EQ(cv::countNonZero(CandidateRegion(Paper(), Paper(), {}) == 0), 0);
}

TEST(CandidateRegion, IsTheWholeImageWhenTheLampDimmed) {
  cv::Mat hand = Paper() * 0.85;
  cv::rectangle(hand, {0, 100}, {100, 180}, cv::Scalar(6, 60, 5), cv::FILLED);
  EXPECT_EQ(cv::countNonZero(CandidateRegion(Paper(), hand, {}) == 0), 0);
}

}  // namespace
}  // namespace dorsum
