// SPDX-License-Identifier: Apache-2.0
#include "imaging/pieces.h"

#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

TEST(Pieces, AreThoseOfOpenCv) {
  std::mt19937 random(7);
  for (const double share : {0.1, 0.5, 0.6, 0.9}) {
    cv::Mat mask(37, 53, CV_8UC1);
    std::bernoulli_distribution set(share);
    for (int v = 0; v < mask.rows; ++v) {
      for (int u = 0; u < mask.cols; ++u) mask.at<std::uint8_t>(v, u) = set(random) ? 255 : 0;
    }
    cv::Mat labels;
    const int count = cv::connectedComponents(mask, labels, 4, CV_32S) - 1;
    const Pieces pieces(mask, 255);
    EXPECT_EQ(pieces.count(), count);
    std::set<std::pair<int, int>> pairs;  // of a label and a piece: as many as there are pieces
    int area = 0;
    for (const Pieces::Run& run : pieces.runs()) {
      for (int u = run.first; u < run.end; ++u) pairs.emplace(labels.at<int>(run.v, u), run.piece);
      area += run.end - run.first;
    }
    EXPECT_EQ(pairs.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(area, cv::countNonZero(mask));
  }
}

TEST(Pieces, OfAnotherValueAndOfNothing) {
  const cv::Mat empty(3, 4, CV_8UC1, cv::Scalar(0));
  EXPECT_EQ(Pieces(empty, 255).count(), 0);
  EXPECT_EQ(Pieces(empty, 0).count(), 1);
  EXPECT_EQ(Pieces(empty, 0).runs().size(), 3U);
  EXPECT_EQ(Pieces(cv::Mat(), 0).count(), 0);
}

}  // namespace
}  // namespace dorsum
