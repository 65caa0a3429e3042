// SPDX-License-Identifier: Apache-2.0
#include "report/correction_pictures.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

// Boxes of 10 to 50 mm whose reconstruction is 1 mm too high on the right and as much too low on the left.
std::vector<HeightSample> Samples() {
  std::vector<HeightSample> samples;
  for (double h = 10.0; h <= 50.0; h += 10.0) {
    for (double x = -60.0; x <= 60.0; x += 0.5) samples.push_back({x, h + x / 60.0, h});
  }
  return samples;
}

// Mean of red minus blue over a part of the plot.
double Redness(const cv::Mat& picture, cv::Rect part) {
  const cv::Scalar mean = cv::mean(picture(part));
  return mean[2] - mean[0];
}

TEST(CorrectionPictures, ScalesCoverTheSamples) {
  const CorrectionScales scales = ScalesOf(Samples());
  EXPECT_LE(scales.x.low, -60.0);
  EXPECT_GE(scales.x.high, 60.0);
  EXPECT_DOUBLE_EQ(scales.z.low, 0.0);
  EXPECT_GE(scales.error_mm, 0.9);
  EXPECT_LE(scales.error_mm, 1.3);
}

TEST(CorrectionPictures, TooHighIsRedAndTooLowIsBlue) {
  const std::vector<HeightSample> samples = Samples();
  const cv::Mat picture = DrawCorrectionSamples(samples, ScalesOf(samples));
  ASSERT_EQ(picture.size(), cv::Size(640, 480));
  EXPECT_LT(Redness(picture, {90, 60, 80, 340}), -2.0);
  EXPECT_GT(Redness(picture, {440, 60, 80, 340}), 2.0);
  CorrectionPolynomial polynomial;
  polynomial.c[1] = 1.0 / 60.0 / 30.0;
  const cv::Mat fitted = DrawCorrectionPolynomial(polynomial, ScalesOf(samples));
  EXPECT_LT(Redness(fitted, {90, 60, 80, 340}), -20.0);
  EXPECT_GT(Redness(fitted, {440, 60, 80, 340}), 20.0);
}

TEST(CorrectionPictures, NoSamplesAndNanAreNotACrash) {
  EXPECT_FALSE(DrawCorrectionSamples({}, ScalesOf({})).empty());
  const std::vector<HeightSample> odd = {{std::nan(""), 1.0, 1.0}, {0.0, 10.0, 10.0}};
  EXPECT_FALSE(DrawCorrectionSamples(odd, ScalesOf(odd)).empty());
  EXPECT_FALSE(DrawCorrectionPolynomial({}, ScalesOf(odd)).empty());
}

}  // namespace
}  // namespace dorsum
