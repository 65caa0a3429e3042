// SPDX-License-Identifier: Apache-2.0
#include "speed/allocation_count.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace dorsum::speed {
namespace {

TEST(AllocationCount, SeesImagesAndVectors) {
  AllocationCount large(std::size_t{1} << 20);
  EXPECT_EQ(large.count(), 0);
  const cv::Mat image(1024, 1024, CV_8UC1), small(10, 10, CV_8UC1);
  EXPECT_EQ(large.count(), 1);
  const std::vector<float> numbers(1 << 20);
  EXPECT_EQ(large.count(), 2);
  const cv::Mat same = image;
  EXPECT_EQ(large.count(), 2);
}

}  // namespace
}  // namespace dorsum::speed
