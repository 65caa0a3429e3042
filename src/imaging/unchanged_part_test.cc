// SPDX-License-Identifier: Apache-2.0
#include "imaging/unchanged_part.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(UnchangedPart, IsWhereTheLightIsWhatItWas) {
  const cv::Mat before(42, 61, CV_8UC3, cv::Scalar(20, 200, 30));
  cv::Mat after = before.clone();
  after(cv::Rect(0, 0, 20, 42)).setTo(cv::Scalar(20, 150, 30));   // a quarter darker
  after(cv::Rect(20, 0, 20, 42)).setTo(cv::Scalar(90, 194, 90));  // 3 % darker; other channels do not count
  after.at<cv::Vec3b>(10, 50) = {0, 0, 0};                        // a single pixel is noise
  const UnchangedPart part(before, after);
  const cv::Mat strict = part.Mask(0.06), loose = part.Mask(0.4);
  ASSERT_EQ(strict.size(), before.size());
  EXPECT_EQ(strict.at<std::uint8_t>(5, 10), 0);
  EXPECT_EQ(strict.at<std::uint8_t>(5, 30), 255);
  EXPECT_EQ(strict.at<std::uint8_t>(10, 50), 255);
  EXPECT_EQ(loose.at<std::uint8_t>(5, 10), 255);
  EXPECT_EQ(loose.at<std::uint8_t>(41, 5), 0);  // fills no square
  for (const double share : {0.06, 0.4}) {
    EXPECT_EQ(part.Share(share), cv::countNonZero(part.Mask(share)) / static_cast<double>(before.total()));
  }
}

TEST(UnchangedPart, OfATinyPictureIsNothing) {
  const cv::Mat tiny(2, 3, CV_8UC3, cv::Scalar(9, 9, 9));
  EXPECT_EQ(cv::countNonZero(UnchangedPart(tiny, tiny).Mask(0.4)), 0);
  EXPECT_EQ(UnchangedPart(tiny, tiny).Share(0.4), 0.0);
}

}  // namespace
}  // namespace dorsum
