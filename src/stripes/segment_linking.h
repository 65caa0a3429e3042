// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stripes/stripes.h"

namespace dorsum {

struct SegmentLinkingOptions {
  int slope_rows = 6;           // rows from which a stripe's direction is taken, 2 to 30
  int max_gap_rows = 2;         // rows that may be missing in between, 0 to 10
  double gate_px = 1.5;         // how far the next row's point may lie from where it is expected, px
  double gate_share = 0.5;      // and how much further, in standard deviations of the profile
  double max_slope = 2.5;       // steepest stripe, px per row
  double max_brightness = 2.5;  // largest change of peak from a few rows to the next, as a factor
  int min_rows = 6;             // shortest segment, rows
};

// Joins the points of neighbouring rows into segments: each open segment foretells its next point from its
// last rows, and takes the nearest point within the gate if that point has no nearer segment. `rows` holds
// the points of every image row by growing u. A segment has at most one point per row; points come back by
// segment, the neighbours `top` and `bottom` set.
LaserStripes LinkSegments(const std::vector<std::vector<StripePoint>>& rows, int laser,
                          const SegmentLinkingOptions& options);

// Builds the list from segments given as points by growing row; sets extremes, `segment`, `top`, `bottom`.
LaserStripes AssembleStripes(const std::vector<std::vector<StripePoint>>& segments, int laser);

}  // namespace dorsum
