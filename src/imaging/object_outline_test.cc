// SPDX-License-Identifier: Apache-2.0
#include "imaging/object_outline.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

const cv::Size kSize(160, 120);
constexpr float kBlur = 0.8F;

// A blurred disc of light 0.6 on 1, its centre between pixels.
cv::Mat Disc(cv::Point2f centre, float radius) {
  cv::Mat light(kSize, CV_32FC1);
  for (int v = 0; v < kSize.height; ++v) {
    for (int u = 0; u < kSize.width; ++u) {
      const double out =
          cv::norm(cv::Point2f(static_cast<float>(u), static_cast<float>(v)) - centre) - radius;
      light.at<float>(v, u) = 0.8F + 0.2F * std::erf(static_cast<float>(out) / (kBlur * std::sqrt(2.0F)));
    }
  }
  return light;
}

CellPicture Texture(float value) { return {cv::Mat(15, 20, CV_32FC1, cv::Scalar(value)), 8}; }

TEST(FindOutlines, LieWhereTheLightChangesNotWhereThePixelsEnd) {
  const cv::Point2f centre(80.3F, 59.6F);
  const float radius = 40.4F;
  cv::Mat mask = Disc(centre, radius) < 0.75F;  // not the middle of the edge
  const Outlines outlines = FindOutlines(mask, Disc(centre, radius), Texture(0.003F));
  ASSERT_EQ(outlines.size(), 1U);
  double sum = 0.0;
  for (const cv::Point2f p : outlines[0]) {
    const double off = cv::norm(p - centre) - radius;
    EXPECT_NEAR(off, 0.0, 0.2);
    sum += off;
  }
  EXPECT_NEAR(sum / static_cast<double>(outlines[0].size()), 0.0, 0.06);
}

TEST(FindOutlines, StayWithThePixelsWhereNothingIsSeen) {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  cv::rectangle(mask, {40, 30}, {100, 80}, 255, cv::FILLED);
  cv::Mat noise(kSize, CV_32FC1);
  cv::RNG(3).fill(noise, cv::RNG::NORMAL, 1.0, 0.01);
  const cv::Mat filled = FillOutlines(FindOutlines(mask, noise, Texture(0.014F)), kSize);
  cv::Mat changed = filled != mask;
  EXPECT_LT(cv::countNonZero(changed), 16);  // corners only
}

TEST(FindOutlines, ReachTheImagesBorderAndKeepHoles) {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  cv::rectangle(mask, {0, 30}, {100, 80}, 255, cv::FILLED);
  cv::circle(mask, {50, 55}, 12, 0, cv::FILLED);
  cv::Mat light(kSize, CV_32FC1, cv::Scalar(1.0F));
  light.setTo(0.6F, mask);
  cv::GaussianBlur(light, light, {}, kBlur);
  const Outlines outlines = FindOutlines(mask, light, Texture(0.003F));
  EXPECT_EQ(outlines.size(), 2U);
  const cv::Mat filled = FillOutlines(outlines, kSize);
  EXPECT_LT(cv::countNonZero(filled != mask), 12);
  EXPECT_LE(cv::countNonZero(filled.col(0) != mask.col(0)), 2);  // corners
}

TEST(FillOutlines, TakesPixelsWhoseCentresLieWithin) {
  const cv::Mat mask = FillOutlines({{{1.6F, 0.5F}, {4.4F, 0.5F}, {4.4F, 2.4F}, {1.6F, 2.4F}}}, {6, 4});
  cv::Mat expected = cv::Mat::zeros(4, 6, CV_8UC1);
  expected(cv::Rect(2, 1, 3, 2)).setTo(255);
  EXPECT_EQ(cv::norm(mask, expected, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::countNonZero(FillOutlines({}, {6, 4})), 0);
}

}  // namespace
}  // namespace dorsum
