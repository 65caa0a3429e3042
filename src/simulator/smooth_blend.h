// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace dorsum {

// Unions and cuts of signed distances (negative inside) with a rounded seam. A cubic kernel: two continuous
// derivatives, no effect where the two differ by more than `radius` (mm), at most radius / 6 added where
// equal.
inline double SmoothUnion(double a, double b, double radius) {
  const double h = std::max(radius - std::abs(a - b), 0.0) / radius;
  return std::min(a, b) - h * h * h * radius / 6.0;
}

inline double SmoothIntersection(double a, double b, double radius) { return -SmoothUnion(-a, -b, radius); }

// Rises from 0 at `lo` to 1 at `hi` with two continuous derivatives; `hi` may be below `lo`.
inline double SmoothStep(double lo, double hi, double x) {
  const double t = std::clamp((x - lo) / (hi - lo), 0.0, 1.0);
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

}  // namespace dorsum
