// SPDX-License-Identifier: Apache-2.0
#include "calibration/correction_fit.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

const CorrectionPolynomial kTrue{{0.02, -1.5e-4, 3e-4, 2e-6, -4e-6, 5e-6}};

std::vector<HeightSample> Samples(const std::vector<double>& heights, const std::function<double()>& noise) {
  std::vector<HeightSample> samples;
  for (const double z : heights) {
    for (double x = -90.0; x <= 90.0; x += 5.0) {
      samples.push_back({x, z + noise(), kTrue.CorrectedZ(x, z)});
    }
  }
  return samples;
}

TEST(CorrectionFit, TheKnownPolynomialComesBack) {
  const auto fit = FitCorrection(Samples({5.0, 15.0, 30.0, 45.0}, [] { return 0.0; }));
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  for (const double x : {-90.0, 0.0, 70.0}) {
    for (const double z : {5.0, 40.0})
      EXPECT_NEAR(fit->polynomial.Evaluate(x, z), kTrue.Evaluate(x, z), 1e-9);
  }
  EXPECT_LT(fit->rms_after_mm, 1e-9);
  EXPECT_GT(fit->rms_before_mm, 0.3);
  EXPECT_EQ(fit->samples, 4U * 37U);
}

TEST(CorrectionFit, ResidualsAreOfTheHeightInMillimetres) {
  Rng rng(3);
  const auto samples = Samples({5.0, 15.0, 30.0, 45.0, 60.0}, [&] { return 0.1 * rng.Normal(); });
  const auto fit = FitCorrection(samples);
  ASSERT_TRUE(fit.ok());
  double before = 0.0, mean = 0.0, after = 0.0;
  for (const HeightSample& s : samples) {
    before += std::pow(s.z - s.h, 2);
    mean += s.z - s.h;
    after += std::pow(fit->polynomial.CorrectedZ(s.x, s.z) - s.h, 2);
  }
  const auto n = static_cast<double>(samples.size());
  EXPECT_NEAR(fit->rms_before_mm, std::sqrt(before / n), 1e-12);
  EXPECT_NEAR(fit->mean_before_mm, mean / n, 1e-12);
  EXPECT_NEAR(fit->rms_after_mm, std::sqrt(after / n), 1e-12);
  EXPECT_NEAR(fit->rms_after_mm, 0.1, 0.02);
  EXPECT_LT(std::abs(fit->mean_after_mm), 0.01);
}

TEST(CorrectionFit, WhatDoesNotDetermineItIsAnError) {
  EXPECT_FALSE(FitCorrection({}).ok());
  EXPECT_FALSE(FitCorrection({{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4}, {4, 5, 5}}).ok());
  for (const std::vector<double>& heights : {std::vector<double>{20.0}, std::vector<double>{20.0, 40.0}}) {
    const auto fit = FitCorrection(Samples(heights, [] { return 0.0; }));
    ASSERT_FALSE(fit.ok()) << heights.size() << " heights";
    EXPECT_EQ(fit.error().code, ErrorCode::kBadInput);
  }
  EXPECT_FALSE(FitCorrection(std::vector<HeightSample>(50, {1.0, 0.0, 0.0})).ok());
}

}  // namespace
}  // namespace dorsum
