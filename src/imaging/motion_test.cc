// SPDX-License-Identifier: Apache-2.0
#include "imaging/motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

// A dark disc with soft edges on a bright ground, at `x`, with noise of 2 grey values.
cv::Mat Disc(double x, std::uint64_t seed, double gain = 1.0) {
  cv::Mat picture(300, 400, CV_8UC3);
  Rng rng(seed);
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      const double inside = 1.0 / (1.0 + std::exp((std::hypot(u - x, v - 150.0) - 90.0) / 0.8));
      const double value = gain * (200.0 - 120.0 * inside) + 2.0 * rng.Normal();
      picture.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(value));
    }
  }
  return picture;
}

TEST(Motion, NoiseAloneIsRest) {
  const PictureMotion motion = MeasureMotion(Disc(200.0, 1), Disc(200.0, 2));
  EXPECT_GT(motion.tiles, 5);
  EXPECT_LT(motion.shift_px, 0.1);
}

TEST(Motion, HalfAPixelIsSeen) {
  EXPECT_NEAR(MeasureMotion(Disc(200.0, 1), Disc(200.5, 2)).shift_px, 0.4, 0.15);
}

TEST(Motion, AFarMoveIsNotTakenForRest) {
  for (const double by : {2.0, 6.0, 20.0, 60.0}) {
    EXPECT_GT(MeasureMotion(Disc(200.0, 1), Disc(200.0 + by, 2)).shift_px, 1.0) << by;
  }
}

TEST(Motion, OtherLightIsNotTakenForMotion) {
  EXPECT_LT(MeasureMotion(Disc(200.0, 1), Disc(200.0, 2, 0.9)).shift_px, 0.15);
}

TEST(Motion, AnEmptyPictureHasNothingThatMoves) {
  const cv::Mat black(300, 400, CV_8UC3, cv::Scalar::all(0));
  EXPECT_EQ(MeasureMotion(black, black).shift_px, 0.0);
}

TEST(Motion, PicturesOfTwoSizesAreRefused) {
  EXPECT_THROW(MeasureMotion(Disc(200.0, 1), cv::Mat(10, 10, CV_8UC3)), std::logic_error);
}

}  // namespace
}  // namespace dorsum
