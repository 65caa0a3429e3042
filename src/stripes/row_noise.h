// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stripes/stripe_curve.h"

namespace dorsum {

struct RowNoiseOptions {
  int half_rows = 15;       // of the local quadratics whose residuals are looked at
  double outlier_sd = 4.5;  // a point further off than this is taken out of use
};

// How the rows' errors behave, measured on the curves themselves.
struct RowNoise {
  double scale = 1.0;             // true over formal standard deviation of a single row, all curves together
  std::vector<double> per_curve;  // the same of each curve, drawn towards `scale` where it is short
  RowCorrelation correlation;
};

// Residuals of local fits show only the quick part of the noise, since the fit follows speckle whose grain
// spans some rows. Theory tells what residuals of a correlation would look like, so the correlation is the
// one whose residuals have the observed products one to four rows apart, and the scale makes up for the part
// that the fits took. Only the straighter half of the points counts, so that curvature does not pass for
// noise. Takes points out of use that are far off.
RowNoise MeasureRowNoise(const RowNoiseOptions& options, std::vector<StripeCurve>* curves);

}  // namespace dorsum
