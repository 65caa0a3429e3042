// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "geometry/calibration.h"

namespace dorsum {

// A point reconstructed on a box of known height.
struct HeightSample {
  double x = 0.0, z = 0.0;  // uncorrected, world, mm
  double h = 0.0;           // true height, mm
};

struct CorrectionFit {
  CorrectionPolynomial polynomial;
  double rms_before_mm = 0.0, rms_after_mm = 0.0;
  double mean_before_mm = 0.0, mean_after_mm = 0.0;
  std::size_t samples = 0;
};

// Fits e(x, z) of equation 3.7 by linear least squares. Equation 3.6's relative error is weighted with z, so
// that what is made least is the height error in millimetres, sum (z (1 - e(x, z)) - h)^2; without the weight
// points of small z would rule the fit. An error for fewer than 6 heights-and-places that determine it.
Result<CorrectionFit> FitCorrection(const std::vector<HeightSample>& samples);

}  // namespace dorsum
