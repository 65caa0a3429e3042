// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "stripes/stripes.h"

namespace dorsum {

// Adds points, by growing row, as one segment of that order: sets the points' segment, top and bottom and the
// segment's extremes and brightness. Nothing happens without points.
void AppendSegment(std::span<const StripePoint> points, std::optional<int> order, LaserStripes* out);

// The points whose entry in `keep` is not 0, one entry per point. Segments are parted where points go, and
// keep their order; left and right neighbours are forgotten.
LaserStripes KeepPoints(const LaserStripes& stripes, std::span<const char> keep);

// Sets every segment's min_u and max_u anew after its points were moved.
void UpdateExtremes(LaserStripes* stripes);

}  // namespace dorsum
