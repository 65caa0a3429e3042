// SPDX-License-Identifier: Apache-2.0
#include "speed/floor.h"

#include <gtest/gtest.h>

namespace dorsum::speed {
namespace {

TEST(Floor, SumsEveryByte) {
  const cv::Mat whole(7, 9, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_EQ(SumBytes({whole, whole}), 2U * 7U * 9U * 6U);
  EXPECT_EQ(SumBytes({whole(cv::Rect(2, 3, 4, 2))}), 4U * 2U * 6U);
  EXPECT_EQ(SumBytes({}), 0U);
}

}  // namespace
}  // namespace dorsum::speed
