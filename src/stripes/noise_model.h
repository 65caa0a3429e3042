// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace dorsum {

// Variance of a pixel against its grey value g: read noise, rounding and compression (constant), photons
// (linear), speckle (quadratic). Grey values squared.
struct NoiseModel {
  double constant = 1.0, linear = 0.0, quadratic = 0.0;

  double Variance(double grey) const {
    const double g = std::max(0.0, grey);
    return constant + g * (linear + g * quadratic);
  }
};

// What a pixel should have been, and the square of what it missed.
struct NoiseSample {
  float grey = 0.0F, squared_residual = 0.0F;
};

// Least variance that is believed: rounding to whole grey values alone gives 1/12.
inline constexpr double kLeastVariance = 0.1;

// Fits the three terms, none negative, to trimmed means of the samples in classes of grey value. With fewer
// than 200 samples, `start` comes back.
NoiseModel FitNoiseModel(std::vector<NoiseSample> samples, const NoiseModel& start);

}  // namespace dorsum
