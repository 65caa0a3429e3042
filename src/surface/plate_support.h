// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "surface/outline.h"
#include "surface/plate.h"

namespace dorsum {

struct PlateSupportOptions {
  double step_px = 2.5;        // of the lattice, above 0
  double mm_per_px = 0.2;      // of the object, above 0
  double max_beyond_mm = 7.0;  // how far the surface goes on beyond the last sample, >= 0
  double max_gap_mm = 20.0;    // widest gap between samples that closes, at least twice max_beyond_mm
};

// The lattice on which a surface can be known: nodes on the object, and those next to it that its outline's
// cells need, that samples are near to. Distances run along the object, not across the backplane between
// fingers.
PlateLattice MakeSupport(const std::vector<PlateSample>& samples, const Outline& outline,
                         const PlateSupportOptions& options, const Context& context = {});

// Starts each active node from the median of the samples around it, which outliers in the minority do not
// reach.
void StartFromMedians(const std::vector<PlateSample>& samples, const Context& context, PlateLattice* lattice);

}  // namespace dorsum
