// SPDX-License-Identifier: Apache-2.0
#include "imaging/stripe_mask.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// Green stripes of Gaussian profile on a dark ground; `lean` in columns per row.
cv::Mat Stripes(const std::vector<double>& crests, double lean = 0.0, double sigma = 3.0) {
  cv::Mat image(60, 300, CV_8UC3, cv::Scalar(4, 8, 4));
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      double green = 8.0;
      for (const double crest : crests)
        green += 180.0 * std::exp(-0.5 * std::pow((u - crest - lean * v) / sigma, 2));
      image.at<cv::Vec3b>(v, u)[1] = cv::saturate_cast<uchar>(green);
    }
  }
  return image;
}

// First set column of a row in [from, to), or -1.
int FirstColumn(const cv::Mat& mask, int row, int from, int to) {
  for (int u = from; u < to; ++u) {
    if (mask.at<std::uint8_t>(row, u) != 0) return u;
  }
  return -1;
}

TEST(StripeMask, EachStripeGivesOneRegionThatBeginsAtItsCrest) {
  for (const double lean : {0.0, 0.1}) {
    const cv::Mat mask = ExtractStripeMask(Stripes({60.0, 120.4, 180.7}, lean), {}, {}, "x");
    cv::Mat labels;
    EXPECT_EQ(cv::connectedComponents(mask, labels), 4) << "three stripes and the ground";
    for (int v = 5; v < 55; v += 7) {
      for (const double crest : {60.0, 120.4, 180.7}) {
        const double at = crest + lean * v;
        const int first = FirstColumn(mask, v, static_cast<int>(at) - 25, static_cast<int>(at) + 25);
        EXPECT_NEAR(first, at, 1.0 + 0.5) << "row " << v;
      }
    }
  }
}

TEST(StripeMask, ADarkImageGivesNothing) {
  EXPECT_EQ(cv::countNonZero(ExtractStripeMask(Stripes({}), {}, {}, "x")), 0);
}

TEST(StripeMask, OnlyTheRegionIsLookedAt) {
  cv::Mat region = cv::Mat::zeros(60, 300, CV_8UC1);
  region.colRange(0, 100).setTo(255);
  const cv::Mat mask = ExtractStripeMask(Stripes({60.0, 180.0}), region, {}, "x");
  EXPECT_GT(cv::countNonZero(mask.colRange(0, 100)), 0);
  EXPECT_EQ(cv::countNonZero(mask.colRange(100, 300)), 0);
}

TEST(StripeMask, EverySideThatTheOptionsAllowWorks) {
  // OpenCV throws for even sides.
  for (const int block : {3, 4, 60, 61, 62, 998, 999}) {
    for (const int median : {1, 2, 3, 14, 15}) {
      StripeMaskOptions options;
      options.block_px = block;
      options.median_px = median;
      EXPECT_NO_THROW(ExtractStripeMask(Stripes({60.0}), {}, options, "x")) << block << " " << median;
    }
  }
  StripeMaskOptions even, odd;
  even.block_px = 60;
  odd.block_px = 61;
  const cv::Mat image = Stripes({60.0, 120.0});
  EXPECT_EQ(
      cv::norm(ExtractStripeMask(image, {}, even, "x"), ExtractStripeMask(image, {}, odd, "x"), cv::NORM_INF),
      0.0);
}

}  // namespace
}  // namespace dorsum
