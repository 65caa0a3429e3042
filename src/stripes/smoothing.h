// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stripes/stripes.h"

namespace dorsum {

struct SmoothingOptions {
  int half_window_rows = 5;  // rows on either side that are smoothed together; 0 leaves the stripe as it is
  double max_step_px = 2.5;  // a jump between neighbouring rows above this parts the stripe, px
};

// Segment smoothing of §4.3: parts segments at jumps, replaces each point's u by a line fitted to the rows
// around it (within the segment), updates extremes, and sets each point's top and bottom neighbours.
// Segments that become shorter than min_rows are dropped.
LaserStripes SmoothSegments(const LaserStripes& stripes, int min_rows, const SmoothingOptions& options);

}  // namespace dorsum
