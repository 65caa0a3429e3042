// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stripes/stripes.h"

namespace dorsum {

struct BrightnessPullOptions {
  int half_rows = 8;        // rows to either side that give the brightness' slope, 3 to 30
  int wide_half_rows = 20;  // and rows whose slopes are averaged
  // Usual size of the logarithm's slope across a stripe over that along it: 1 if surfaces fall off in any
  // direction alike, 0 to 2.
  double across_share = 0.8;
};

// How far a stripe's peak may be pulled from the sheet's centre, px, one standard deviation, for each point
// of a segment. A profile exp(-x^2 / (2 s^2)) on a surface whose brightness changes as exp(g x) has its peak
// at s^2 g. The slope g across the stripe cannot be seen in one stripe; the slope along it can, and tells the
// usual size: near outlines and on mottled skin it is large. `points` is one segment by growing row.
std::vector<double> BrightnessPull(const std::vector<StripePoint>& points,
                                   const BrightnessPullOptions& options);

}  // namespace dorsum
