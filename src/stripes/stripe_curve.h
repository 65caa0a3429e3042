// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
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
  std::vector<double> sd;  // px, of the single row
  std::vector<char> use;   // 0: left out of every pool
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

}  // namespace dorsum
