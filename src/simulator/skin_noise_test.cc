// SPDX-License-Identifier: Apache-2.0
#include "simulator/skin_noise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

Eigen::Vector3d Somewhere(Rng& rng) {
  return {rng.Uniform(-200, 200), rng.Uniform(-100, 100), rng.Uniform(0, 50)};
}

TEST(SkinNoiseTest, HasUnitSpreadAndNoBias) {
  const SkinNoise noise(3, 9.0);
  Rng rng(1);
  double sum = 0, squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double value = noise.At(Somewhere(rng));
    sum += value;
    squares += value * value;
    EXPECT_LT(std::abs(value), 7.0);
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.05);
  EXPECT_NEAR(std::sqrt(squares / kCount), 1.0, 0.1);
}

TEST(SkinNoiseTest, IsSmoothAcrossLatticeCells) {
  const SkinNoise noise(3, 2.0);
  Rng rng(2);
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d p = Somewhere(rng), step(1e-4, 2e-4, -1e-4);
    const double before = noise.At(p) - noise.At(p - step), after = noise.At(p + step) - noise.At(p);
    EXPECT_NEAR(before, after, 1e-5);
  }
}

TEST(SkinNoiseTest, SeedsDiffer) {
  const Eigen::Vector3d p(1.5, 2.5, 3.5);
  EXPECT_EQ(SkinNoise(1, 9.0).At(p), SkinNoise(1, 9.0).At(p));
  EXPECT_NE(SkinNoise(1, 9.0).At(p), SkinNoise(7, 9.0).At(p));
}

}  // namespace
}  // namespace dorsum
