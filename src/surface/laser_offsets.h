// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.h"
#include "surface/plate.h"
#include "surface/plate_stack.h"

namespace dorsum {

struct LaserOffsetOptions {
  double mm_per_px = 0.2;  // of the object, above 0
  double prior_mm = 0.05;  // standard deviation of an offset before anything was seen, above 0
  double patch_mm = 8.0;   // side of the patches whose errors count as independent, above 0
};

// By how much a laser's heights lie above the mean of all lasers.
struct LaserOffset {
  int laser = 0;
  double mean_mm = 0.0, sd_mm = 0.0;
};

// Height offsets of the lasers, found together with the surface: the plate and one offset per laser minimise
// the plate's energy (plate.h) plus offset^2 / prior^2. `solved` is the plate without offsets. Its residuals
// r and the plates X_k that fit the indicator of laser k give the Schur complement's normal equations
// (generalised least squares):
//   sum w e_l (e_l - X)' o = sum w e_l r.
// The standard deviations take the scatter of w (e_l - X) r between patches (White's sandwich), since
// neighbouring residuals are not independent. Means are relative to the mean over the lasers. `lasers`: one
// per sample.
std::vector<LaserOffset> EstimateLaserOffsets(const std::vector<PlateSample>& samples,
                                              const std::vector<std::uint8_t>& lasers,
                                              const std::vector<PlateLattice>& indicators,
                                              const PlateGrid& solved, const LaserOffsetOptions& options);

// The plates X_k, in the order of the lasers, but for the last, since all of them add up to 1. They do not
// depend on heights. `stack`: the plate's equations on `grid`, with the samples' weights.
std::vector<PlateLattice> SolveIndicators(const std::vector<PlateSample>& samples,
                                          const std::vector<std::uint8_t>& lasers, const PlateStack& stack,
                                          const PlateGrid& grid, const PlateOptions& plate,
                                          const Context& context = {});

}  // namespace dorsum
