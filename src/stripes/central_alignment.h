// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include "stripes/stripe_tree.h"

namespace dorsum {

// Order, as a real number, of a stripe at this pixel if it lay at the bottom and at the top of the working
// volume.
using OrderRange = std::function<std::pair<double, double>(float u, float v)>;

struct CentralAlignmentOptions {
  // How much brighter than both neighbours the central stripe must be, 1 to 10. Below that no stripe stands
  // out and the one whose heights fit the working volume lowest is taken.
  double min_ratio = 1.25;
  // Fewest points of a level that can be central, as a share of the median level: a remnant of a bright
  // stripe on the backplane is not the central stripe, 0 to 1.
  double min_points_share = 0.3;
};

// Stripe indices alignment (§3.5): the level with the highest mean brightness becomes order 0, among those
// whose place allows order 0 within the working volume. Sets the order of every segment; returns the level
// that became 0.
int AlignToCentralStripe(const StripeTree& tree, const OrderRange& range,
                         const CentralAlignmentOptions& options, LaserStripes* stripes);

}  // namespace dorsum
