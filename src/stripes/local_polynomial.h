// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stripes/stripes.h"

namespace dorsum {

// A stripe as a function of the row, prepared for local regression.
struct StripeCurve {
  std::vector<double> v, u;  // px
  // The regression's variable: the angle of v = middle - half length * cos(angle). Where a stripe runs over
  // the round edge of an object, u goes with the square root of the distance to the end: a straight line in
  // it.
  std::vector<double> angle;
  std::vector<double> sd, weight;  // px, of the single row; 1 / sd^2
  std::vector<char> use;           // 0: left out of every pool
};

// One curve per segment, without angles.
std::vector<StripeCurve> CurvesOf(const LaserStripes& stripes);

// What local regression needs besides.
void MeasureAngles(StripeCurve* curve);

// Correlation of the errors of two rows k > 0 apart: share * decay^k. A share below 1 leaves some noise to
// each row alone; above 1, neighbours are more alike than an exponential has it, as speckle's are.
struct RowCorrelation {
  double share = 0.0, decay = 0.5;

  double At(int rows) const { return rows == 0 ? 1.0 : share * std::pow(decay, rows); }
};

struct LocalEstimate {
  bool ok = false;
  double u = 0.0, sd = 0.0;  // px
};

// Weighted least-squares quadratics through the usable points of a growing window around point k, evaluated
// there.
class LocalQuadratic {
 public:
  LocalQuadratic(const StripeCurve& curve, std::size_t k) : curve_(curve), k_(k), first_(k), end_(k) {}

  // Widens the window to [first, last], which holds all that it held before and k.
  void Widen(std::size_t first, std::size_t last);

  // The estimate and its standard deviation when errors of neighbouring rows are correlated.
  LocalEstimate Estimate(const RowCorrelation& correlation) const;

 private:
  void Add(std::size_t i);

  const StripeCurve& curve_;
  std::size_t k_, first_, end_;
  std::array<double, 5> moments_{};  // of the angle from point k
  std::array<double, 3> right_{};
  int count_ = 0;
};

}  // namespace dorsum
