// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
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
  static constexpr int kFrame = 2;
  using Range = std::pair<std::size_t, std::size_t>;  // begin and end, in whole blocks

  // The plate's resistance to bending, and its tension, without samples.
  PlateSystem(const PlateOptions& options, const PlateLattice& lattice);

  // Adds samples, which have a place and a weight each; those without one are left out. With `each` above 1,
  // only every so many, which stand for the others.
  void AddSamples(std::span<const LatticePlace> places, std::span<const float> weights, std::size_t each = 1);
  // Adds to a right side of size() values what samples with these heights bring.
  void AddHeights(std::span<const float> heights, std::span<const LatticePlace> places,
                  std::span<const float> weights, std::vector<float>* right) const;
  // Takes the forces off a right side that hold the heights x against bending; of a system without samples.
  void SubtractBending(const std::vector<float>& x, std::vector<float>* right) const;

  // To be called when the system is whole: what the solver needs of the diagonal.
  void Finish();

  std::size_t At(int c, int r) const {
    return static_cast<std::size_t>(r + kFrame) * cols_ + static_cast<std::size_t>(c + kFrame);
  }
  std::size_t size() const { return diagonal.size(); }
  std::size_t columns() const { return cols_; }  // of the storage
  // Distances to the neighbours of `upper`.
  std::array<std::ptrdiff_t, 6> Offsets() const {
    const auto wide = static_cast<std::ptrdiff_t>(cols_);
    return {1, 2, wide - 1, wide, wide + 1, 2 * wide};
  }
  // The runs that hold all nodes of the lattice.
  const std::vector<Range>& runs() const { return runs_; }
  // Of each row of nodes, the columns of the storage from its first node to its last; empty when it has none.
  const std::vector<Range>& spans() const { return spans_; }

  // A lattice's heights as the solver takes them, 0 where there is no node; and back.
  std::vector<float> Gather(const PlateLattice& lattice) const;
  void Scatter(const std::vector<float>& x, PlateLattice* lattice) const;

  std::vector<float> diagonal, inverse;  // inverse: of the diagonal, 0 where there is no node
  std::array<std::vector<float>, 6> upper;

 private:
  void FindRuns(const cv::Mat1b& active);

  std::size_t cols_;  // with the frame
  std::vector<Range> runs_, spans_;
};

}  // namespace dorsum
