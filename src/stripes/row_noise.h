// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stripes/local_polynomial.h"

namespace dorsum {

// How the rows' errors behave, measured on the curves themselves.
struct RowNoise {
  double scale = 1.0;             // true over formal standard deviation of a single row, all curves together
  std::vector<double> per_curve;  // the same of each curve, drawn towards `scale` where it is short
  RowCorrelation correlation{};   // [0] is 1
};

// From the residuals against local quadratics over half_rows[i][k] rows to either side of point k of curve i.
// Takes points out of use that lie further than `outlier_sd` off.
RowNoise MeasureRowNoise(const std::vector<std::vector<int>>& half_rows, double outlier_sd,
                         std::vector<StripeCurve>* curves);

}  // namespace dorsum
