// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_stack.h"

#include <algorithm>
#include <cstdint>
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

PlateStack::PlateStack(const PlateOptions& options, std::span<const PlateGrid> grids) {
  PlateLattice now = grids[0].lattice;
  std::vector<PlateSystem> bending;
  bending.reserve(grids.size());
  bending.emplace_back(options, now);
  for (const PlateGrid& grid : grids.subspan(1)) {
    const cv::Mat3f stiffness = EverySecond(now.stiffness, grid.lattice.active.size());
    now = grid.lattice;
    now.stiffness = stiffness;
    bending.emplace_back(options, now);
  }
  bending_ = std::make_shared<const std::vector<PlateSystem>>(std::move(bending));
}

void PlateStack::SetSamples(std::span<const float> weights, std::span<const PlateGrid> grids) {
  systems_ = *bending_;
  for (std::size_t k = 0; k < systems_.size(); ++k) {
    // Stripes lie close enough that every fourth sample, four times, tells the coarser ones the same.
    systems_[k].AddSamples(grids[k].places, weights, k == 0 ? 1 : 4);
    systems_[k].Finish();
  }
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
