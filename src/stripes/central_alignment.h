// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include "stripes/stripe_tree.h"

namespace dorsum {

// Order, as a real number, of a stripe at this pixel if it lay at the bottom and at the top of the working
// volume.
using OrderRange = std::function<std::pair<double, double>(float u, float v)>;

// How bright a stripe of this order is on the empty backplane; any scale, above 0.
using ReferencePeak = std::function<double(int order)>;

struct CentralAlignmentOptions {
  // Least share of points whose heights lie in the working volume, 0 to 1.
  double min_in_volume = 0.8;
  // Fewest points of a level that speaks for or against being central, as a share of the median level, 0 to
  // 1: a remnant of a stripe on the backplane is bright, but short.
  double min_points_share = 0.3;
  // How much of the central order's brightness over its neighbours' on the backplane a level must show to be
  // central, as a share of the logarithm, 0 to 1.
  double min_contrast = 0.5;
};

// Stripe indices alignment (§3.5): which level is order 0? The document takes the brightest. Here a level
// must stand out against its neighbours as the central order does on the backplane; numberings that put the
// object outside the working volume are out; and where no level stands out, because the central stripe misses
// the object, the lowest heights win. Sets the order of every segment; returns the level that became 0.
int AlignToCentralStripe(const StripeTree& tree, const OrderRange& range, const ReferencePeak& reference_peak,
                         const CentralAlignmentOptions& options, LaserStripes* stripes);

}  // namespace dorsum
