// SPDX-License-Identifier: Apache-2.0
#include "imaging/iterative_threshold.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(IterativeThreshold, LiesMidwayBetweenTwoGroups) {
  cv::Mat image(40, 40, CV_8UC1);
  cv::theRNG().state = 7;
  cv::randn(image.rowRange(0, 20), 50, 5);
  cv::randn(image.rowRange(20, 40), 180, 5);
  EXPECT_NEAR(IterativeThreshold(image), 115.0, 2.0);
}

TEST(IterativeThreshold, ASmallObjectStillHasItsOwnGroup) {
  // The mean alone would lie at 22, within reach of the large group.
  cv::Mat image(100, 100, CV_8UC1, cv::Scalar(20));
  image.rowRange(0, 1).setTo(220);
  EXPECT_NEAR(IterativeThreshold(image), 120.0, 0.1);
  image.setTo(220);
  image.rowRange(0, 1).setTo(20);
  EXPECT_NEAR(IterativeThreshold(image), 120.0, 0.1);
}

TEST(IterativeThreshold, OneValueHasNothingAboveIt) {
  for (const int value : {0, 1, 77, 255}) {
    EXPECT_NEAR(IterativeThreshold(cv::Mat(5, 5, CV_8UC1, cv::Scalar(value))), value, 1e-9);
  }
}

TEST(IterativeThreshold, NeighbouringValuesAreTold) {
  cv::Mat image(2, 2, CV_8UC1, cv::Scalar(254));
  image.at<std::uint8_t>(0, 0) = 255;
  const double threshold = IterativeThreshold(image);
  EXPECT_GE(threshold, 254.0);
  EXPECT_LT(threshold, 255.0);
}

TEST(IterativeThreshold, OtherImagesAreABrokenContract) {
  EXPECT_THROW(IterativeThreshold(cv::Mat()), std::logic_error);
  EXPECT_THROW(IterativeThreshold(cv::Mat(3, 3, CV_8UC3)), std::logic_error);
}

}  // namespace
}  // namespace dorsum
