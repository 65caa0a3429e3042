// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dorsum {
namespace {

constexpr double kWider = 1.4;

double Gauss(int i, double sd) { return std::exp(-0.5 * i * i / (sd * sd)); }

// f(0) + 2 sum of f(i) up to `half`.
template <class F>
double SumOfBothSides(int half, const F& f) {
  double sum = f(0);
  for (int i = 1; i <= half; ++i) sum += 2.0 * f(i);
  return sum;
}

// Rounds from the ends inwards, each value with what rounding took from those before; the middle takes what
// is left to `whole`.
template <class F>
std::vector<std::int16_t> Rounded(int half, int whole, const F& f) {
  std::vector<std::int16_t> out(static_cast<std::size_t>(half) + 1);
  int rest = whole;
  double taken = 0.0;
  for (int i = half; i > 0; --i) {
    const auto value = static_cast<std::int16_t>(std::lround(f(i) + taken));
    out[static_cast<std::size_t>(i)] = value;
    taken += f(i) - value;
    rest -= 2 * value;
  }
  out[0] = static_cast<std::int16_t>(rest);
  return out;
}

double SquareSum(const std::vector<std::int16_t>& kernel, double unit) {
  return SumOfBothSides(static_cast<int>(kernel.size()) - 1, [&](int i) {
    const double value = kernel[static_cast<std::size_t>(i)] / unit;
    return value * value;
  });
}

}  // namespace

double RidgeKernel::NoiseGain() const { return SquareSum(rows, kRowUnit) * SquareSum(columns, kColumnUnit); }

RidgeKernel MakeRidgeKernel(double width_px) {
  RidgeKernel kernel;
  const double sd = kWider * width_px;
  const auto wide = [sd](int i) { return Gauss(i, sd); };
  const int rows = std::clamp(static_cast<int>(std::lround(2.0 * width_px)), 2, 4);
  const double row_sum = SumOfBothSides(rows, wide);
  kernel.rows =
      Rounded(rows, RidgeKernel::kRowUnit, [&](int i) { return RidgeKernel::kRowUnit * wide(i) / row_sum; });
  const int half = std::max(3, static_cast<int>(std::lround(3.0 * sd)));
  const double mean = SumOfBothSides(half, wide) / (2.0 * half + 1.0);
  const double own = SumOfBothSides(half, [&](int i) { return (wide(i) - mean) * Gauss(i, width_px); });
  kernel.columns = Rounded(half, 0, [&](int i) { return RidgeKernel::kColumnUnit * (wide(i) - mean) / own; });
  return kernel;
}

}  // namespace dorsum
