// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/context.h"
#include "surface/plate.h"
#include "surface/plate_solver.h"
#include "surface/plate_system.h"

namespace dorsum {

// A lattice and where the samples lie on it.
struct PlateGrid {
  PlateLattice lattice;
  std::vector<LatticePlace> places;  // one per sample
};

// The lattice and those that are twice, four times ... as coarse, until nodes are more than 6 mm apart. Those
// have heights 0 and no stiffness.
std::vector<PlateGrid> MakeGrids(const PlateLattice& lattice, double mm_per_px,
                                 const std::vector<PlateSample>& samples, const Context& context = {});

// A plate's equations on a lattice and on the coarser ones that its solution goes through (plate_solver.h).
class PlateStack {
 public:
  // Without samples. `grids`: from the lattice to be solved, whose stiffness the coarser ones take over.
  PlateStack(const PlateOptions& options, std::span<const PlateGrid> grids, const Context& context = {});

  // Samples with these weights, in place of those before. `grids`: as above.
  void SetSamples(std::span<const float> weights, std::span<const PlateGrid> grids,
                  const Context& context = {});
  // The same for the lattice to be solved alone: good enough where the weights have changed little.
  void UpdateSamples(std::span<const float> weights, const PlateGrid& grid);

  // The plate for the samples' heights; weights and grid as they were set. Starts from lattice->z. Returns
  // the iterations made.
  int Solve(std::span<const float> heights, std::span<const float> weights, const PlateGrid& grid,
            const PlateOptions& options, PlateSolver* solver, PlateLattice* lattice) const;

 private:
  std::shared_ptr<const std::vector<PlateSystem>> bending_;  // copies share it
  std::vector<PlateSystem> systems_;
};

}  // namespace dorsum
