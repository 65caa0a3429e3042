// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "stripes/joint_graph.h"

namespace dorsum {

// In which order sweeps go over the pieces: those of the left half of them, from their outer end inwards;
// those of the right half, likewise; and last those of either half that have an edge to the other one.
// Nothing joins the first two, so that a sweep can go over both at the same time.
struct SweepOrder {
  std::vector<std::size_t> pieces;
  std::size_t left_end = 0, right_end = 0;  // places in it
};

// By the column of each piece's middle sample; the same at any number of threads.
SweepOrder OrderSweeps(const std::vector<JointPiece>& pieces, const JointGraph& graph);

}  // namespace dorsum
