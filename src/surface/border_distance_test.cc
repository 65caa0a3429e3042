// SPDX-License-Identifier: Apache-2.0
#include "surface/border_distance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

TEST(BorderDistanceTest, ItIsTheExactDistanceUpToItsReach) {
  std::mt19937 random(4);
  cv::Mat1b region(90, 217, std::uint8_t{255});
  for (int i = 0; i < 25; ++i) {
    region(static_cast<int>(random() % 90), static_cast<int>(random() % 217)) = 0;
  }
  region(cv::Rect(0, 40, 60, 50)).setTo(0);
  cv::Mat1f exact;
  cv::distanceTransform(region, exact, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (const int reach : {1, 7, 30, kMaxBorderReach}) {
    const cv::Mat1w found = SquaredBorderDistance(region, reach);
    for (int r = 0; r < region.rows; ++r) {
      for (int c = 0; c < region.cols; ++c) {
        EXPECT_EQ(found(r, c), std::min<long>(std::lround(std::pow(exact(r, c), 2)), long{reach} * reach))
            << reach << " " << c << " " << r;
      }
    }
  }
}

TEST(BorderDistanceTest, ThePicturesEdgeIsNoBorder) {
  const cv::Mat1w found = SquaredBorderDistance(cv::Mat1b(5, 40, std::uint8_t{1}), 20);
  EXPECT_EQ(cv::countNonZero(found != 400), 0);
}

}  // namespace
}  // namespace dorsum
