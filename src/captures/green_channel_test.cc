// SPDX-License-Identifier: Apache-2.0
#include "captures/green_channel.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(GreenChannel, IsTheSecondOfThreeInEveryPixel) {
  for (const int cols : {1, 31, 64, 200}) {
    cv::Mat3b whole(7, cols + 5);
    for (int v = 0; v < whole.rows; ++v) {
      for (int u = 0; u < whole.cols; ++u) {
        whole(v, u) = {static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(7 * u + 31 * v),
                       static_cast<std::uint8_t>(v)};
      }
    }
    const cv::Mat part = whole(cv::Rect(2, 1, cols, 5));  // rows do not follow each other
    const cv::Mat green = GreenChannel(part);
    ASSERT_EQ(green.size(), part.size());
    for (int v = 0; v < 5; ++v) {
      for (int u = 0; u < cols; ++u)
        ASSERT_EQ(green.at<std::uint8_t>(v, u), part.at<cv::Vec3b>(v, u)[1]) << u << " " << v;
    }
  }
}

TEST(GreenChannel, IsAPictureOfOneChannelItself) {
  const cv::Mat green(3, 3, CV_8UC1, cv::Scalar(7));
  EXPECT_EQ(GreenChannel(green).data, green.data);
}

TEST(GreenChannel, NeedsOneChannelOrThree) {
  EXPECT_THROW(GreenChannel(cv::Mat(3, 3, CV_8UC4)), std::logic_error);
  EXPECT_THROW(GreenChannel(cv::Mat(3, 3, CV_16UC1)), std::logic_error);
  EXPECT_TRUE(GreenChannel(cv::Mat(0, 0, CV_8UC3)).empty());
}

}  // namespace
}  // namespace dorsum
