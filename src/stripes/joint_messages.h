// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "stripes/joint_graph.h"

namespace dorsum {

struct MessagePassingOptions {
  int max_sweeps = 16;      // over all pieces, forth or back, 1 to 1000
  double tolerance = 0.05;  // change of a message that ends the sweeps
};

// Candidates of small total cost by sequential tree-reweighted message passing (Kolmogorov, "Convergent
// tree-reweighted message passing for energy minimization", PAMI 2006, figure 2), from both sides inwards
// (sweep_order.h): each sweep sends messages ahead only, and the next one sends them back. -1 for pieces
// without candidates.
std::vector<int> PassMessages(const std::vector<JointPiece>& pieces, const JointGraph& graph,
                              const MessagePassingOptions& options, const Context& context = {});

}  // namespace dorsum
