// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "surface/plate.h"
#include "surface/surface_point.h"

namespace dorsum {

// A sample's height after rows were pooled (stripes/pooling.h).
struct PooledHeight {
  float change_mm = 0.0F;  // to the height of the rows alone
  float weight = 0.0F;     // mm^-2; 0 leaves the sample out
};

// Rows of a stripe that follow each other, as one sample of the surface each few rows: to a lattice that is
// coarser than the rows, it says what they say. All of one size.
struct GatheredRows {
  std::vector<PlateSample> samples;  // the rows' own heights, at their mean place
  std::vector<PooledHeight> pooled;
  std::vector<std::uint8_t> lasers;
};

// Gathers up to `most` neighbouring rows of one segment whose heights agree within their sigmas, with their
// variances as weights. Points that are `left_out` become samples of their own, without weight. No point
// counts as better than `least_sigma`, mm.
GatheredRows GatherRows(const SurfacePoints& points, const std::vector<bool>& left_out, int most,
                        float least_sigma);

}  // namespace dorsum
