// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"
#include "calibration/stripe_spacing.h"

namespace dorsum {

struct GratingHeight {
  double height_mm = 0.0;            // l of equation 3.4
  double spacing_further_mm = 0.0;   // x
  double spacing_closer_mm = 0.0;    // y
  int from_order = 0, to_order = 0;  // stripes seen at both distances, counted from the central one
};

// l = h / (1 - y / x), equation 3.4, from the mean spacings over the stripes that are seen at both distances:
// with other stripes at each the means would not compare, since the spacing grows towards the outer orders.
Result<GratingHeight> EstimateGratingHeight(const PlaneStripes& further, const PlaneStripes& closer,
                                            double object_height_mm, int laser);

}  // namespace dorsum
