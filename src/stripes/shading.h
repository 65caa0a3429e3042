// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "stripes/profile_fit.h"
#include "stripes/shaded_row.h"
#include "stripes/stripes.h"
#include "stripes/surface_brightness.h"

namespace dorsum {

struct ShadingOptions {
  SurfaceBrightnessOptions brightness = {};
  ShadedRowOptions row = {};
  // A row's brightness against what its stripe has on a surface as bright as there, natural logarithm: only a
  // flank is seen below `dark`; below `dim` with a centre that is known no better than `vague_sd` widths;
  // below `dusky` with a profile narrower than `narrow` of what is usual.
  double dark = -1.2, dim = -0.7, vague_sd = 0.15, dusky = -0.4, narrow = 0.72;
  double left_over = 0.5;  // share of the pull that this is taken to leave, 0 to 1
};

// Fits every row of the stripes that have an order once more, now that it is known how bright the surface is
// beside the stripe: a surface that grows darker across a stripe, as it does towards an outline, at a wrinkle
// or a mole, pulls the peak by about width^2 d ln(brightness) / du; next to an outline or a step only one
// flank is there. Centres on the dark side of a step are taken out: the sheet's middle misses the surface.
// `pictures` are of stripes->lasers, one each. Rows must not be pooled yet.
void FitOnShadedSurface(const SurfaceBrightness& brightness, const std::vector<LaserPicture>& pictures,
                        const ProfileFitOptions& fit, const ShadingOptions& options, const Context& context,
                        IndexedStripes* stripes);

}  // namespace dorsum
