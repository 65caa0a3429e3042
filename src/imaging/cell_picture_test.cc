// SPDX-License-Identifier: Apache-2.0
#include "imaging/cell_picture.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

cv::Mat Cells() {
  cv::Mat cells(3, 4, CV_32FC1);
  for (int y = 0; y < cells.rows; ++y) {
    for (int x = 0; x < cells.cols; ++x) cells.at<float>(y, x) = static_cast<float>(10 * y * y + x);
  }
  return cells;
}

TEST(CellPicture, IsTheEnlargedPicture) {
  const cv::Mat cells = Cells();
  cv::Mat large;
  cv::resize(cells, large, {32, 24}, 0, 0, cv::INTER_LINEAR);
  const CellPicture picture(cells, 8);
  for (int v = 0; v < large.rows; ++v) {
    for (int u = 0; u < large.cols; ++u) EXPECT_NEAR(picture.At(u, v), large.at<float>(v, u), 1e-4F);
  }
}

TEST(CellPicture, APartOfTwiceTheSizeShowsEachPixelFourTimes) {
  const CellPicture picture(Cells(), 8), part = picture.Part({3, 5}, 2, 0.5F);
  for (int v = 0; v < 20; ++v) {
    for (int u = 0; u < 20; ++u) EXPECT_FLOAT_EQ(part.At(u, v), 0.5F * picture.At(3 + u / 2, 5 + v / 2));
  }
}

}  // namespace
}  // namespace dorsum
