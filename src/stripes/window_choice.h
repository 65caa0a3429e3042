// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "stripes/stripe_curve.h"

namespace dorsum {

struct WindowChoiceOptions {
  std::span<const int> half_rows;  // of the windows that are tried, growing, at most kMostWindows
  double confidence = 2.7;  // standard deviations within which a window's estimate agrees with another's
  double scale = 1.0;       // true over formal standard deviation of the rows
  RowCorrelation correlation;
};
inline constexpr std::size_t kMostWindows = 16;

struct WindowChoice {
  int half_rows = 0;         // 0: no window holds rows enough
  double u = 0.0, sd = 0.0;  // px
};

// For each of a curve's points that are `every` apart, counted from `first`, the weighted least-squares
// quadratic in the angle through the usable points of a window around it, evaluated there, and its standard
// deviation when errors of neighbouring rows are correlated. Windows grow while their estimate contradicts
// none of a smaller one's.
std::vector<WindowChoice> ChooseWindows(const StripeCurve& curve, std::size_t first, std::size_t every,
                                        const WindowChoiceOptions& options);

}  // namespace dorsum
