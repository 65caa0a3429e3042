// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_pool.h"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

cv::Mat In(PicturePool& pool, cv::Size size, int type) {
  cv::Mat out;
  out.allocator = &pool;
  out.create(size, type);
  return out;
}

TEST(PicturePoolTest, APictureGetsTheMemoryOfOneThatIsGone) {
  PicturePool pool;
  const uchar* first = nullptr;
  {
    const cv::Mat a = In(pool, {640, 480}, CV_8UC3);
    first = a.data;
    const cv::Mat shared = a;
    EXPECT_EQ(pool.unused_bytes(), 0U);
  }
  EXPECT_GE(pool.unused_bytes(), 640U * 480U * 3U);
  const cv::Mat b = In(pool, {320, 240}, CV_32FC3);  // as large
  EXPECT_EQ(b.data, first);
  EXPECT_EQ(pool.unused_bytes(), 0U);
  EXPECT_NE(In(pool, {640, 480}, CV_8UC3).data, first) << "that one is in use";
}

TEST(PicturePoolTest, ASmallPictureDoesNotHoldALargeOnesMemory) {
  PicturePool pool;
  const uchar* large = In(pool, {2000, 1000}, CV_8UC1).data;
  const cv::Mat small = In(pool, {300, 300}, CV_8UC1);
  EXPECT_NE(small.data, large);
  const cv::Mat nearly = In(pool, {1500, 1000}, CV_8UC1);
  EXPECT_EQ(nearly.data, large);
}

TEST(PicturePoolTest, MatricesAreWhatTheyAlwaysAre) {
  PicturePool pool;
  const cv::Mat a = In(pool, {33, 7}, CV_16SC2);
  EXPECT_TRUE(a.isContinuous());
  EXPECT_EQ(a.step[0], 33U * 4U);
  EXPECT_EQ(a.step[1], 4U);
  cv::Mat cube;
  cube.allocator = &pool;
  const int sizes[] = {3, 4, 5};
  cube.create(3, sizes, CV_32FC1);
  cube = cv::Scalar(2.0);
  EXPECT_EQ(cv::sum(cube)[0], 120.0);
  const cv::Mat part = In(pool, {700, 500}, CV_8UC1)(cv::Rect(10, 20, 30, 40));
  EXPECT_EQ(part.step[0], 700U) << "its memory lives as long as the part";
}

TEST(PicturePoolTest, KeepsNoMoreThanItMay) {
  PicturePool pool(std::size_t{1} << 20);
  In(pool, {1000, 1000}, CV_8UC1);
  const std::size_t one = pool.unused_bytes();
  EXPECT_GE(one, 1000000U);
  { const cv::Mat a = In(pool, {900, 900}, CV_8UC1), b = In(pool, {1000, 1000}, CV_8UC1); }
  EXPECT_LE(pool.unused_bytes(), std::size_t{1} << 20);
}

TEST(PicturePoolTest, WhatIsNoLongerUsedMakesRoom) {
  PicturePool pool(std::size_t{4} << 20);
  { const cv::Mat a = In(pool, {1000, 2000}, CV_8UC1), b = In(pool, {1000, 2000}, CV_8UC1); }
  In(pool, {800, 800}, CV_8UC1);
  const std::size_t unused = pool.unused_bytes();
  EXPECT_LE(unused, std::size_t{4} << 20);
  const cv::Mat again = In(pool, {800, 800}, CV_8UC1);
  EXPECT_LE(pool.unused_bytes() + again.total(), unused) << "it came from elsewhere";
}

TEST(PicturePoolTest, ManyThreadsMayUseIt) {
  PicturePool pool;
  std::vector<std::jthread> threads;
  threads.reserve(4);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&pool, t] {
      for (int i = 0; i < 200; ++i) {
        cv::Mat a = In(pool, {300 + i % 3 * 100, 300}, CV_8UC1);
        a = cv::Scalar(t);
        ASSERT_EQ(cv::countNonZero(a != t), 0) << "another thread's memory";
      }
    });
  }
}

}  // namespace
}  // namespace dorsum
