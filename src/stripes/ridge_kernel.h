// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace dorsum {

// A filter that answers to a stripe's profile with about its amplitude: one kernel across the stripe, along
// the row, and one over the rows beside it. Both are symmetric, so each is kept from its middle outwards, and
// in integers, so that every machine gives the same.
struct RidgeKernel {
  static constexpr int kRowUnit = 64;          // the whole kernel over the rows has this sum
  static constexpr int kColumnUnit = 1 << 15;  // stands for 1 in the kernel along the row
  std::vector<std::int16_t> rows;              // not negative
  std::vector<std::int16_t> columns;           // the whole kernel has the sum 0, 2 to 64 values

  // Variance of the response to noise of variance 1 in every pixel.
  double NoiseGain() const;

  bool operator==(const RidgeKernel&) const = default;
};

// For profiles whose standard deviation is `width_px`, 0.7 to 8. Both kernels are Gaussians wider than that
// by 1.4, the one along the row without its mean: the top of what it leaves of a noisy profile lies closer to
// the centre than that of a filter as wide as the profile itself. Its scale is such that a stripe alone gives
// its amplitude.
RidgeKernel MakeRidgeKernel(double width_px);

}  // namespace dorsum
