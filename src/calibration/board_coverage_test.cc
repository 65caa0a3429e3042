// SPDX-License-Identifier: Apache-2.0
#include "calibration/board_coverage.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

std::vector<cv::Point2f> Grid(cv::Rect2f area) {
  std::vector<cv::Point2f> corners;
  for (int v = 0; v < 8; ++v) {
    for (int u = 0; u < 11; ++u) {
      corners.emplace_back(area.x + area.width * static_cast<float>(u) / 10.0F,
                           area.y + area.height * static_cast<float>(v) / 7.0F);
    }
  }
  return corners;
}

TEST(BoardCoverage, ABoardOnTheLeftLeavesTheRightMissing) {
  BoardCoverage coverage({1600, 1200});
  EXPECT_EQ(coverage.Share(), 0.0);
  coverage.Add(Grid({5, 5, 790, 1190}));
  EXPECT_NEAR(coverage.Share(), 0.5, 0.01);
  EXPECT_EQ(coverage.Missing(), "top right");
}

TEST(BoardCoverage, NothingIsMissingWhenAllIsCovered) {
  BoardCoverage coverage({1600, 1200});
  coverage.Add(Grid({5, 5, 1590, 1190}));
  EXPECT_GT(coverage.Share(), 0.95);
  EXPECT_EQ(coverage.Missing(), "");
}

TEST(BoardCoverage, CornersOutsideThePictureCountForNothing) {
  BoardCoverage coverage({1600, 1200});
  coverage.Add({{-5.0F, 3.0F}, {1600.0F, 10.0F}, {10.0F, 1e9F}});
  EXPECT_EQ(coverage.Share(), 0.0);
}

TEST(BoardCoverage, ABoardThatWasNotMovedIsTheSameView) {
  EXPECT_TRUE(SameView(Grid({5, 5, 700, 500}), Grid({6, 5, 700, 500}), 10.0));
  EXPECT_FALSE(SameView(Grid({5, 5, 700, 500}), Grid({60, 5, 700, 500}), 10.0));
  EXPECT_FALSE(SameView(Grid({5, 5, 700, 500}), {}, 10.0));
}

}  // namespace
}  // namespace dorsum
