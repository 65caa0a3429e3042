// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stripes/joint_graph.h"
#include "stripes/joint_messages.h"

namespace dorsum {

struct JointInferenceOptions {
  MessagePassingOptions messages;
  int cluster_rounds = 10;      // of shifting whole surfaces, 0 to 100
  double smooth_cost = 1.15;    // cost of one observation below which two pieces are on one surface
  double most_for_steps = 2.0;  // what all steps at a surface's edges together may say of its height
};

// The cheapest candidates found, and how sure they are.
struct JointLabels {
  std::vector<int> candidate;  // by piece; -1 where there is none
  // Cost that the second best choice would add: of the piece alone, and of the whole surface that it is part
  // of, moved by one order of all lasers.
  std::vector<double> own_margin, surface_margin;
  std::vector<int> surface;  // to which one the piece belongs
};

// PassMessages() first, then single pieces and whole surfaces are moved by one order at a time as long as
// that costs less.
JointLabels InferLabels(const std::vector<JointPiece>& pieces, const JointGraph& graph,
                        const JointInferenceOptions& options, const Context& context = {});

}  // namespace dorsum
