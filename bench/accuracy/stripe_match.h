// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "accuracy/capture_truth.h"
#include "surface/surface_point.h"

namespace dorsum::accuracy {

// Points of a reconstruction beside the true stripes, laser by laser and image row by image row.
struct StripeMatch {
  int wanted = 0, found = 0;  // true, lit stripe points on the object; those with a point within 1.5 px, 2 mm
  std::vector<char> stray;    // by point: no true stripe of its laser lies within 3 px in its row
};
StripeMatch MatchStripes(const CaptureTruth& truth, const SurfacePoints& points);

// The nearest true stripe of the point's laser in the point's row; null when the row has none.
const TrueStripe* NearestStripe(const CaptureTruth& truth, const SurfacePoint& point);

}  // namespace dorsum::accuracy
