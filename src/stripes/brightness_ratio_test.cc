// SPDX-License-Identifier: Apache-2.0
#include "stripes/brightness_ratio.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

// Stripes every 20 px over a picture whose level waves along v.
std::vector<RatioSample> Stripes(double along_u, double of_level) {
  std::vector<RatioSample> samples;
  for (int u = 10; u < 200; u += 20) {
    for (int v = 0; v < 160; ++v) {
      const double level = 4.0 + 0.5 * std::sin(0.3 * v);
      samples.push_back({static_cast<float>(u), static_cast<float>(v),
                         static_cast<float>(along_u * (u - 100) + of_level * (level - 4.0)),
                         static_cast<float>(level)});
    }
  }
  return samples;
}

TEST(BrightnessRatio, FindsTheSlopesOnAndBetweenStripes) {
  const BrightnessRatio ratio({200, 160}, Stripes(0.004, -0.6), 9.0, {});
  for (const double u : {90.0, 99.0, 110.0}) {
    const RatioSlope slope = ratio.At(u, 80.0, 4.1);
    EXPECT_NEAR(slope.along_u, 0.003, 0.001) << u;
    EXPECT_NEAR(slope.of_level, -0.6, 0.1) << u;
  }
}

TEST(BrightnessRatio, KnowsNothingWhereNoStripeIs) {
  EXPECT_EQ(BrightnessRatio().At(3.0, 4.0, 4.0).along_u, 0.0);
  const BrightnessRatio none({200, 160}, {}, 9.0, {});
  EXPECT_EQ(none.At(100.0, 80.0, 4.0).along_u, 0.0);
  EXPECT_EQ(none.At(-5.0, 900.0, 4.0).of_level, 0.0);
}

TEST(BrightnessRatio, IsTheSameAtAnyNumberOfThreads) {
  const std::vector<RatioSample> samples = Stripes(0.002, 0.3);
  Context one, four;
  one.threads = 1;
  four.threads = 4;
  const BrightnessRatio a({200, 160}, samples, 9.0, one), b({200, 160}, samples, 9.0, four);
  for (double u = 0.0; u < 200.0; u += 7.0) {
    EXPECT_EQ(a.At(u, 50.0, 4.0).along_u, b.At(u, 50.0, 4.0).along_u);
    EXPECT_EQ(a.At(u, 50.0, 4.0).of_level, b.At(u, 50.0, 4.0).of_level);
  }
}

}  // namespace
}  // namespace dorsum
