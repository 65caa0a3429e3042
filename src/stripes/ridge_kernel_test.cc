// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_kernel.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stripes/ridge_response.h"

namespace dorsum {
namespace {

int Sum(const std::vector<std::int16_t>& half) {
  int sum = half[0];
  for (std::size_t k = 1; k < half.size(); ++k) sum += 2 * half[k];
  return sum;
}

TEST(RidgeKernel, HasItsSumsAndFallsOffTowardsTheEnds) {
  for (const double width : {0.7, 1.0, 2.0, 3.3, 8.0}) {
    const RidgeKernel kernel = MakeRidgeKernel(width);
    EXPECT_EQ(Sum(kernel.rows), RidgeKernel::kRowUnit) << width;
    EXPECT_EQ(Sum(kernel.columns), 0) << width;
    EXPECT_LE(kernel.columns.size(), 64U);
    for (const auto* half : {&kernel.rows, &kernel.columns}) {
      for (std::size_t k = 1; k < half->size(); ++k) EXPECT_LE((*half)[k], (*half)[k - 1] + 1) << width;
    }
    EXPECT_GE(kernel.rows.back(), 0);
  }
}

TEST(RidgeKernel, AStripeAnswersWithItsAmplitude) {
  for (const double width : {0.7, 1.0, 2.0, 3.3, 8.0}) {
    RidgeResponse response(MakeRidgeKernel(width));
    cv::Mat1b green(9, 161);
    for (int u = 0; u < green.cols; ++u) {
      const double t = (u - 80) / width;
      green.col(u) = static_cast<std::uint8_t>(std::lround(40.0 + 150.0 * std::exp(-0.5 * t * t)));
    }
    response.Compute(green, 4, 0, green.cols);
    EXPECT_NEAR(RidgeResponse::kUnit * response.response()[80], 150.0, 2.0) << width;
    EXPECT_NEAR(response.response()[10], 0, 2) << width;
  }
}

TEST(RidgeKernel, AWiderOneGathersLessNoise) {
  EXPECT_GT(MakeRidgeKernel(1.0).NoiseGain(), MakeRidgeKernel(2.0).NoiseGain());
  EXPECT_GT(MakeRidgeKernel(2.0).NoiseGain(), MakeRidgeKernel(4.0).NoiseGain());
}

}  // namespace
}  // namespace dorsum
