// SPDX-License-Identifier: Apache-2.0
#include "report/height_picture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "report/colours.h"

namespace dorsum {
namespace {

HeightField Flat(float z) {
  HeightField field;
  field.origin_mm = {-50.0, -30.0};
  field.pitch_mm = 1.0;
  field.z = cv::Mat1f(61, 101, z);
  return field;
}

// The mean place of yellow, the top of the colour scale, left of the scale itself.
cv::Point2d Summit(const cv::Mat& picture) {
  cv::Point2d sum;
  double count = 0.0;
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 84; column < picture.cols - 120; ++column) {
      const auto& c = picture.at<Colour>(row, column);
      if (c[2] < 180 || c[1] < 180 || c[0] > 120) continue;
      sum += cv::Point2d(column, row);
      count += 1.0;
    }
  }
  return count > 0.0 ? sum * (1.0 / count) : cv::Point2d(-1.0, -1.0);
}

TEST(HeightPicture, ABumpAtLargeXAndYIsAtTheUpperRight) {
  HeightField field = Flat(5.0F);
  for (int r = 45; r < 55; ++r) {
    for (int c = 80; c < 95; ++c) field.z(r, c) = 30.0F;
  }
  const cv::Mat picture =
      DrawHeightMap(field, {.width_px = 800, .height_px = 600, .contour_mm = 0.0, .relief = 0.0});
  const cv::Point2d summit = Summit(picture);
  // 596 px show x from -55 to 55 mm; the bump's middle is at (37.0, 19.5) mm.
  EXPECT_NEAR(summit.x, 84.0 + (37.0 + 55.0) / 110.0 * 596.0, 4.0);
  EXPECT_NEAR(summit.y, 44.0 + (35.0 - 19.5) / 110.0 * 596.0, 4.0);
}

TEST(HeightPicture, UnseenPlacesStayWhite) {
  HeightField field = Flat(10.0F);
  field.z(cv::Rect(40, 20, 20, 20)) = std::numeric_limits<float>::quiet_NaN();
  field.z(0, 0) = 0.0F;
  const cv::Mat picture = DrawHeightMap(field, {.width_px = 800, .height_px = 600});
  // (2, 2) mm lies in the hole and on no grid line.
  const int column = 84 + static_cast<int>((2.0 + 55.0) / 110.0 * 596.0);
  const int row = 44 + static_cast<int>((35.0 - 2.0) / 110.0 * 596.0);
  EXPECT_EQ(picture.at<Colour>(row, column), Colour(255, 255, 255));
}

TEST(HeightPicture, NothingSeenIsNotACrash) {
  EXPECT_FALSE(DrawHeightMap({}).empty());
  EXPECT_FALSE(DrawHeightMap(Flat(std::numeric_limits<float>::quiet_NaN())).empty());
  EXPECT_FALSE(DrawHeightMap(Flat(0.0F)).empty());
}

TEST(HeightPicture, PictureKeepsWithinTheAskedSize) {
  const cv::Mat picture = DrawHeightMap(Flat(3.0F), {.width_px = 700, .height_px = 500});
  EXPECT_LE(picture.cols, 700);
  EXPECT_LE(picture.rows, 500);
  EXPECT_GT(picture.cols, 600);
}

}  // namespace
}  // namespace dorsum
