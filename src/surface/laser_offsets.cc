// SPDX-License-Identifier: Apache-2.0
#include "surface/laser_offsets.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "base/parallel.h"
#include "surface/patches.h"

namespace dorsum {
namespace {

// A surface that follows its samples leaves residuals that are smaller than their errors.
constexpr double kResidualsToErrors = 2.0;
// mm; a surface's own relief between stripes passes for an offset up to about this much (measured on hands
// without noise).
constexpr double kRelief = 0.01;

// The lasers that have samples, growing.
std::vector<int> Present(const std::vector<std::uint8_t>& lasers) {
  std::array<bool, 256> seen{};
  for (const std::uint8_t laser : lasers) seen[laser] = true;
  std::vector<int> out;
  for (int laser = 0; laser < 256; ++laser) {
    if (seen[static_cast<std::size_t>(laser)]) out.push_back(laser);
  }
  return out;
}

}  // namespace

std::vector<PlateLattice> SolveIndicators(const std::vector<PlateSample>& samples,
                                          const std::vector<std::uint8_t>& lasers, const PlateStack& stack,
                                          const PlateGrid& grid, const PlateOptions& plate,
                                          const Context& context) {
  const std::vector<int> present = Present(lasers);
  if (present.size() < 2) return {};
  std::vector<float> weights;
  weights.reserve(samples.size());
  for (const PlateSample& s : samples) weights.push_back(s.weight);
  // No plate resists being lifted, so the indicators of all lasers add up to 1 and the last needs no
  // solution.
  std::vector<PlateLattice> indicators(present.size() - 1, grid.lattice);
  ParallelFor(context, 0, static_cast<std::int64_t>(indicators.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    PlateLattice& x = indicators[k];
    x.z = cv::Mat1f(grid.lattice.z.size(), 1.0F / static_cast<float>(present.size()));
    std::vector<float> marked;
    marked.reserve(samples.size());
    for (const std::uint8_t laser : lasers) marked.push_back(laser == present[k] ? 1.0F : 0.0F);
    PlateSolver solver;
    stack.Solve(marked, weights, grid, plate, &solver, &x);
  });
  return indicators;
}

std::vector<LaserOffset> EstimateLaserOffsets(const std::vector<PlateSample>& samples,
                                              const std::vector<std::uint8_t>& lasers,
                                              const std::vector<PlateLattice>& indicators,
                                              const PlateGrid& solved, const LaserOffsetOptions& options) {
  std::vector<LaserOffset> out;
  std::vector<int> index(256, -1);
  for (const int laser : Present(lasers)) {
    index[static_cast<std::size_t>(laser)] = static_cast<int>(out.size());
    out.push_back({.laser = laser});
  }
  const auto n = static_cast<Eigen::Index>(out.size());
  if (n < 2) return out;

  const Eigen::MatrixXd known = Eigen::MatrixXd::Identity(n, n) / (options.prior_mm * options.prior_mm);
  Eigen::MatrixXd normal = known, scatter = known;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), row(n);

  // Of each patch, the sums of w r row and of w row row'.
  const Patches patches(samples, options.patch_mm / options.mm_per_px);
  const auto count = static_cast<Eigen::Index>(patches.size());
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(n, count), h = Eigen::MatrixXd::Zero(n, n * count);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlateSample& s = samples[i];
    const float z = HeightAt(solved.lattice, solved.places[i]);
    if (s.weight <= 0.0F || !std::isfinite(z)) continue;
    row[n - 1] = -1.0;
    for (Eigen::Index k = 0; k + 1 < n; ++k) {
      row[k] = -HeightAt(indicators[static_cast<std::size_t>(k)], solved.places[i]);
      row[n - 1] -= row[k];
    }
    const Eigen::Index own = index[lasers[i]];
    row[own] += 1.0;
    const double weight = s.weight, error = weight * (s.z - z);
    const auto patch = static_cast<Eigen::Index>(patches.At(s));
    right[own] += error;
    for (Eigen::Index k = 0; k < n; ++k) {
      const double weighted = weight * row[k];
      normal(k, own) += weighted;
      g(k, patch) += error * row[k];
      for (Eigen::Index j = 0; j < n; ++j) h(j, patch * n + k) += weighted * row[j];
    }
  }
  normal = (0.5 * (normal + normal.transpose())).eval();
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd offsets = inverse * right;
  for (Eigen::Index patch = 0; patch < count; ++patch) {
    const Eigen::VectorXd rest = g.col(patch) - h.middleCols(patch * n, n) * offsets;
    scatter += rest * rest.transpose();
  }
  const Eigen::MatrixXd centred =
      Eigen::MatrixXd::Identity(n, n) - Eigen::MatrixXd::Constant(n, n, 1.0 / static_cast<double>(n));
  const Eigen::VectorXd means = centred * offsets;
  const Eigen::MatrixXd covariance = centred * inverse * scatter * inverse * centred;
  for (Eigen::Index k = 0; k < n; ++k) {
    out[static_cast<std::size_t>(k)].mean_mm = means[k];
    out[static_cast<std::size_t>(k)].sd_mm =
        std::hypot(kResidualsToErrors * std::sqrt(covariance(k, k)), kRelief);
  }
  return out;
}

}  // namespace dorsum
