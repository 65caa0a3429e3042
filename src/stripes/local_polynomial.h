// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace dorsum {

// A stripe as a function of the row, prepared for local regression.
struct StripeCurve {
  std::vector<double> v, u;  // px
  std::vector<double> sd;    // px, of the single row
  std::vector<char> use;     // 0: left out of every pool
};

// Correlation of the errors of rows 0, 1, 2 ... apart; beyond, none.
inline constexpr std::size_t kLags = 8;
using RowCorrelation = std::array<double, kLags>;

struct LocalEstimate {
  bool ok = false;
  double u = 0.0, slope = 0.0;  // px, px per row
  double sd = 0.0;              // px
};

// Weighted least-squares quadratic through the usable points [first, last] around row v, evaluated there, and
// its standard deviation when errors of neighbouring rows are correlated.
LocalEstimate FitLocally(const StripeCurve& curve, std::size_t first, std::size_t last, double v,
                         const RowCorrelation& correlation);

}  // namespace dorsum
