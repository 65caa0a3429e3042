// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_stack.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr double kCoarsestStepMm = 6.0;

// Stiffness changes slowly, so every second node's will do.
cv::Mat3f EverySecond(const cv::Mat3f& stiffness, cv::Size size) {
  cv::Mat3f out(size);
  for (int r = 0; r < out.rows; ++r) {
    const auto* in = stiffness.ptr<cv::Vec3f>(std::min(2 * r, stiffness.rows - 1));
    auto* to = out.ptr<cv::Vec3f>(r);
    for (int c = 0; c < out.cols; ++c) to[c] = in[std::min(2 * c, stiffness.cols - 1)];
  }
  return out;
}

// What `make` returns for each number below `count`, found side by side.
template <class Make>
std::vector<PlateSystem> ForEach(std::size_t count, const Context& context, const Make& make) {
  std::vector<std::optional<PlateSystem>> made(count);
  ParallelFor(context, 0, static_cast<std::int64_t>(count), [&](std::int64_t k) {
    made[static_cast<std::size_t>(k)].emplace(make(static_cast<std::size_t>(k)));
  });
  std::vector<PlateSystem> out;
  out.reserve(count);
  for (auto& one : made) out.push_back(std::move(*one));
  return out;
}

}  // namespace

std::vector<PlateGrid> MakeGrids(const PlateLattice& lattice, double mm_per_px,
                                 const std::vector<PlateSample>& samples, const Context& context) {
  std::vector<PlateGrid> grids = {{lattice, {}}};
  while (grids.back().lattice.step_px * mm_per_px <= kCoarsestStepMm) {
    grids.push_back({Coarsen(grids.back().lattice), {}});
  }
  ParallelFor(context, 0, static_cast<std::int64_t>(grids.size()), [&](std::int64_t i) {
    PlateGrid& grid = grids[static_cast<std::size_t>(i)];
    grid.places = FindPlaces(grid.lattice, samples);
  });
  return grids;
}

PlateStack::PlateStack(const PlateOptions& options, std::span<const PlateGrid> grids,
                       const Context& context) {
  std::vector<PlateLattice> lattices;
  lattices.reserve(grids.size());
  for (const PlateGrid& grid : grids) {
    lattices.push_back(grid.lattice);
    if (lattices.size() == 1) continue;
    PlateLattice& now = lattices.back();
    now.stiffness = EverySecond(lattices[lattices.size() - 2].stiffness, now.active.size());
  }
  bending_ = std::make_shared<const std::vector<PlateSystem>>(
      ForEach(grids.size(), context, [&](std::size_t k) { return PlateSystem(options, lattices[k]); }));
}

void PlateStack::SetSamples(std::span<const float> weights, std::span<const PlateGrid> grids,
                            const Context& context) {
  systems_ = ForEach(grids.size(), context, [&](std::size_t k) {
    PlateSystem system = (*bending_)[k];
    // Stripes lie close enough that every fourth sample, four times, tells the coarser ones the same.
    system.AddSamples(grids[k].places, weights, k == 0 ? 1 : 4);
    system.Finish();
    return system;
  });
}

void PlateStack::UpdateSamples(std::span<const float> weights, const PlateGrid& grid) {
  systems_[0] = bending_->front();
  systems_[0].AddSamples(grid.places, weights);
  systems_[0].Finish();
}

// What is solved for is the step from where the lattice stands, and its right side comes from differences:
// the sums of a row's large coefficients times heights would leave rounding errors that lift a surface by
// micrometres.
int PlateStack::Solve(std::span<const float> heights, std::span<const float> weights, const PlateGrid& grid,
                      const PlateOptions& options, PlateSolver* solver, PlateLattice* lattice) const {
  std::vector<float> right(systems_[0].size(), 0.0F), x = systems_[0].Gather(*lattice), rest;
  rest.reserve(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
    rest.push_back(heights[i] - HeightAt(*lattice, grid.places[i]));
  systems_[0].AddHeights(rest, grid.places, weights, &right);
  bending_->front().SubtractBending(x, &right);
  std::vector<float> step(x.size(), 0.0F);
  const int iterations = solver->Solve(systems_, right, options.max_iterations, options.tolerance, &step);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += step[i];
  systems_[0].Scatter(x, lattice);
  return iterations;
}

}  // namespace dorsum
