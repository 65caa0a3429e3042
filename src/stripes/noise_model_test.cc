// SPDX-License-Identifier: Apache-2.0
#include "stripes/noise_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

std::vector<NoiseSample> Draw(const NoiseModel& truth, int count, double outliers) {
  Rng rng(NamedSeed("noise model"));
  std::vector<NoiseSample> samples;
  for (int i = 0; i < count; ++i) {
    const double grey = 200.0 * std::pow(rng.Uniform(), 3.0);
    double r = std::sqrt(truth.Variance(grey)) * rng.Normal();
    if (rng.Uniform() < outliers) r += 40.0;
    samples.push_back({static_cast<float>(grey), static_cast<float>(r * r)});
  }
  return samples;
}

TEST(NoiseModel, FindsReadNoisePhotonsAndSpeckleDespiteOutliers) {
  const NoiseModel truth{2.0, 0.1, 0.002};
  const NoiseModel found = FitNoiseModel(Draw(truth, 20000, 0.005), {});
  for (const double grey : {0.0, 10.0, 50.0, 150.0}) {
    EXPECT_NEAR(found.Variance(grey) / truth.Variance(grey), 1.0, 0.15) << grey;
  }
}

TEST(NoiseModel, NoTermIsNegativeAndRoundingIsTheLeast) {
  const NoiseModel found = FitNoiseModel(Draw({0.0, 0.0, 0.0}, 2000, 0.0), {});
  EXPECT_GE(found.constant, kLeastVariance);
  EXPECT_GE(found.linear, 0.0);
  EXPECT_GE(found.quadratic, 0.0);
  EXPECT_NEAR(found.Variance(-5.0), found.constant, 1e-12);
}

TEST(NoiseModel, FewSamplesLeaveTheStartAsItIs) {
  const NoiseModel start{3.0, 0.2, 0.01};
  const NoiseModel found = FitNoiseModel(Draw({1.0, 0.0, 0.0}, 50, 0.0), start);
  EXPECT_EQ(found.constant, start.constant);
  EXPECT_EQ(found.quadratic, start.quadratic);
}

}  // namespace
}  // namespace dorsum
