// SPDX-License-Identifier: Apache-2.0
#include "jobs/stripe_noise.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

// A sensor whose numbers are so fine that rounding hardly shows.
SensorDesign Sensor(double full_well, double read_noise) {
  SensorDesign sensor;
  sensor.full_well_e = full_well;
  sensor.read_noise_e = read_noise;
  return sensor;
}

constexpr SpeckleDesign kNoSpeckle{0.0, 0.0};

TEST(StripeNoise, ReadNoiseAloneGivesTheClosedForm) {
  // 1 / integral of p'^2 over V: 2 w V / (sqrt(pi) A^2). Few electrons, so that reading out drowns the
  // photons.
  const SensorDesign sensor = Sensor(100.0, 100.0);
  const double w = 2.0, peak = 0.5, step = 1.0 / 255.0;
  const double variance = 1.0 + step * step / 12.0;
  const double expected = std::sqrt(2.0 * w * variance / (std::sqrt(std::numbers::pi) * peak * peak));
  const CentreNoise noise = StripeCentreNoise({peak, w, 0.0, 1.0, 0.0}, sensor, kNoSpeckle);
  EXPECT_NEAR(noise.row_px / expected, 1.0, 0.01);
  EXPECT_EQ(noise.speckle_px, 0.0);
}

TEST(StripeNoise, PhotonsAloneGiveWidthOverTheRootOfTheirNumber) {
  const SensorDesign sensor = Sensor(500.0, 0.0);
  const double w = 2.5, peak = 0.6;
  const double photons = peak * 500.0 * w * std::sqrt(2.0 * std::numbers::pi);
  const CentreNoise noise = StripeCentreNoise({peak, w, 0.0, 1.0, 0.0}, sensor, kNoSpeckle);
  EXPECT_NEAR(noise.row_px / (w / std::sqrt(photons)), 1.0, 0.03);
}

// Draws rows as the virtual sensor does and measures their centres with the same weights.
TEST(StripeNoise, DrawnRowsWithSpeckleScatterAsStated) {
  const SpeckleDesign speckle{0.15, 0.6};
  const SensorDesign sensor = Sensor(9000.0, 9.0);
  const double w = 2.0, peak = 0.5;
  const CentreNoise stated = StripeCentreNoise({peak, w, 0.0, 1.0, 0.0}, sensor, speckle);
  Rng rng(7);
  constexpr int kHalf = 6, kPad = 4, kRows = 20000;
  double squares = 0.0;
  std::vector<double> kernel;
  double norm = 0.0;
  for (int i = -kPad; i <= kPad; ++i) {
    kernel.push_back(std::exp(-0.5 * i * i / (speckle.correlation_px * speckle.correlation_px)));
    norm += kernel.back() * kernel.back();
  }
  for (int row = 0; row < kRows; ++row) {
    std::vector<double> white;
    white.reserve(2 * (kHalf + kPad) + 1);
    for (int i = 0; i < 2 * (kHalf + kPad) + 1; ++i) white.push_back(rng.Normal());
    double top = 0.0, information = 0.0;
    for (int i = -kHalf; i <= kHalf; ++i) {
      const double u = i + 0.25, light = peak * std::exp(-0.5 * u * u / (w * w)),
                   slope = -u / (w * w) * light;
      double grain = 0.0;
      for (int j = -kPad; j <= kPad; ++j) {
        grain += kernel[static_cast<std::size_t>(j + kPad)] *
                 white[static_cast<std::size_t>(i + j + kHalf + kPad)] / std::sqrt(norm);
      }
      const double photons = (light * 9000.0 + 81.0) / (9000.0 * 9000.0) + 1.0 / (255.0 * 255.0 * 12.0);
      const double miss = speckle.contrast * light * grain + std::sqrt(photons) * rng.Normal();
      const double variance = photons + std::pow(speckle.contrast * light, 2);
      top += slope * miss / variance;
      information += slope * slope / variance;
    }
    squares += std::pow(top / information, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / kRows) / stated.row_px, 1.0, 0.04);
  EXPECT_GT(stated.speckle_px, stated.white_px) << "speckle is what limits a bright stripe";
}

TEST(StripeNoise, PoolingHelpsLessAgainstSpeckle) {
  CentreNoise noise{0.1, 0.0, 0.1, 0.0};
  const SpeckleDesign speckle{0.15, 0.6};
  EXPECT_NEAR(noise.PooledPx(31, speckle), 0.1 * std::sqrt(2.25 / 31.0), 1e-3);
  EXPECT_EQ(noise.PooledPx(1, speckle), 0.1);
  noise = {0.0, 0.1, 0.1, 0.0};
  EXPECT_NEAR(noise.PooledPx(31, speckle), 0.1 * std::sqrt(2.25 / 31.0 * 2.12), 2e-3);
}

TEST(StripeNoise, ASaturatedTopCostsAndDarknessCostsAll) {
  const SensorDesign sensor = Sensor(9000.0, 9.0);
  const CentreNoise clipped = StripeCentreNoise({2.0, 2.0, 0.0, 1.0, 0.0}, sensor, kNoSpeckle);
  EXPECT_GT(clipped.saturated, 0.1);
  EXPECT_TRUE(std::isfinite(clipped.row_px));
  EXPECT_FALSE(std::isfinite(StripeCentreNoise({0.0, 2.0, 0.0, 1.0, 0.0}, sensor, kNoSpeckle).row_px));
  SensorDesign mosaic = sensor;
  mosaic.bayer = true;
  EXPECT_NEAR(StripeCentreNoise({0.5, 2.0, 0.0, 1.0, 0.01}, mosaic, kNoSpeckle).row_px /
                  StripeCentreNoise({0.5, 2.0, 0.0, 1.0, 0.01}, sensor, kNoSpeckle).row_px,
              std::sqrt(2.0), 0.05);
}

}  // namespace
}  // namespace dorsum
