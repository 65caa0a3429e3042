// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "surface/plate_system.h"

namespace dorsum {

// Solves plates by conjugate gradients, each step of which is preconditioned with one cycle over several
// grids (Briggs, Henson & McCormick 2000; Tatebe 1993): what samples say reaches a whole gap in one step,
// where a diagonal preconditioner carries it from node to node. Keeps its buffers from one solution to the
// next.
class PlateSolver {
 public:
  // Minimises systems[0] with the right side `right`; x, which starts from 0, and it hold systems[0].size()
  // values.
  // The other systems stand for the same plate, each on a lattice twice as coarse as the one before
  // (Coarsen), and need not be exact. Stops at `tolerance`, the preconditioned residual against its start.
  // Returns the iterations made.
  int Solve(std::span<const PlateSystem> systems, const std::vector<float>& right, int max_iterations,
            double tolerance, std::vector<float>* x);

  // What one cycle needs of a grid.
  struct Grid {
    std::vector<float> x, other, right, residual;
  };

 private:
  std::vector<Grid> grids_;
  std::vector<float> direction_, image_;
};

}  // namespace dorsum
