// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "stripes/stripe_tree.h"

namespace dorsum {

// Order, as a real number, of a stripe at this pixel (u, v) if it lay on the backplane: the scale in which
// distances between stripes are counted.
using BackplaneOrder = std::function<double(float u, float v)>;

struct GapCorrectionOptions {
  // V of Algorithm 2 in usual spacings: stripes further apart than this have others missing between them, 1
  // to 3.
  double max_spacings = 1.5;
};

// Indexing error corrections (§3.5, Algorithm 2): where a node is further than V from its predecessor, the
// number of missing stripes is counted from the distance, and the new index is propagated to the node's
// children. Stripes without a predecessor in their rows begin trees of their own; these are placed, the
// largest first, by the distance to the nearest stripe already placed. Changes the levels of the tree's
// nodes; returns how many predecessors were too far and how many trees were placed.
int CorrectGaps(const LaserStripes& stripes, const BackplaneOrder& backplane_order,
                const GapCorrectionOptions& options, StripeTree* tree);

}  // namespace dorsum
