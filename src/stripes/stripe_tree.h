// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stripes/stripes.h"

namespace dorsum {

struct StripeTree {
  std::vector<StripeNode> nodes;    // one per segment
  std::vector<std::int32_t> roots;  // segments with nothing to their left, by growing u
};

// Second half of Algorithm 1 (§3.5, Figure 3.6): sets the left and right neighbours of all points (next
// stripe in the same row), and from them the hierarchy of segments: the parents of a segment are the
// segments that stand left of it in at least `min_shared_rows` rows. A node's level is one more than its
// strongest parent's (the one that shares most rows).
StripeTree BuildStripeTree(LaserStripes* stripes, int min_shared_rows);

}  // namespace dorsum
