// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "surface/plate.h"

namespace dorsum {

// The normal equations of a plate (plate.h): a symmetric matrix over the nodes of a lattice. For each node
// its diagonal and the coefficients towards the six neighbours that come later. Rows of nodes are stored
// with a frame of empty nodes, whose coefficients are all 0, and begin at whole blocks, so that no border
// needs a test.
class PlateSystem {
 public:
  static constexpr std::size_t kBlock = 16;  // nodes that are worked on together

  // The plate's resistance to bending, and its tension, without samples.
  PlateSystem(const PlateOptions& options, const PlateLattice& lattice);

  // Samples without four active corners, or without weight, are left out.
  void AddSamples(const std::vector<PlateSample>& samples, const PlateLattice& lattice);

  // To be called when the system is whole: what the solver needs of the diagonal.
  void Finish();

  std::size_t At(int c, int r) const {
    return static_cast<std::size_t>(r + kFrame) * cols_ + static_cast<std::size_t>(c + kFrame);
  }
  std::size_t size() const { return diagonal.size(); }
  // Distances to the neighbours of `upper`.
  std::array<std::ptrdiff_t, 6> Offsets() const {
    const auto wide = static_cast<std::ptrdiff_t>(cols_);
    return {1, 2, wide - 1, wide, wide + 1, 2 * wide};
  }
  // Begin and end of the runs that hold all nodes with coefficients, in whole blocks.
  const std::vector<std::pair<std::size_t, std::size_t>>& runs() const { return runs_; }

  std::vector<float> diagonal, right, inverse;  // inverse: of the diagonal, 0 where there is no node
  std::array<std::vector<float>, 6> upper;

 private:
  static constexpr int kFrame = 2;
  template <std::size_t N>
  void Add(const std::array<std::size_t, N>& at, const std::array<float, N>& a,
           const std::array<int, N*(N - 1) / 2>& neighbours, float weight);

  std::size_t cols_;  // with the frame
  std::vector<std::pair<std::size_t, std::size_t>> runs_;
};

// Minimises by conjugate gradients with a diagonal preconditioner from *x, of system.size() values. Stops at
// `tolerance`, the residual against its start. Returns the iterations made.
int SolveByGradients(const PlateSystem& system, int max_iterations, double tolerance, std::vector<float>* x);

}  // namespace dorsum
