// SPDX-License-Identifier: Apache-2.0
#include "surface/laser_offsets.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "base/parallel.h"

namespace dorsum {
namespace {

// A surface that follows its samples leaves residuals that are smaller than their errors.
constexpr double kResidualsToErrors = 2.0;
// mm; a surface's own relief between stripes passes for an offset up to about this much (measured on hands
// without noise).
constexpr double kRelief = 0.01;

}  // namespace

std::vector<LaserOffset> EstimateLaserOffsets(const std::vector<PlateSample>& samples,
                                              const std::vector<std::uint8_t>& lasers,
                                              const PlateLattice& solved, const PlateOptions& plate,
                                              const LaserOffsetOptions& options, const Context& context) {
  std::map<int, int> index;
  for (const std::uint8_t laser : lasers) index.emplace(laser, 0);
  std::vector<LaserOffset> out;
  for (auto& [laser, k] : index) {
    k = static_cast<int>(out.size());
    out.push_back({.laser = laser});
  }
  const auto n = static_cast<Eigen::Index>(out.size());
  if (n < 2) return out;

  std::vector<PlateLattice> indicators(out.size(), solved);
  ParallelFor(context, 0, n, [&](std::int64_t k) {
    PlateLattice& x = indicators[static_cast<std::size_t>(k)];
    x.z = cv::Mat1f(solved.z.size(), 1.0F / static_cast<float>(n));
    std::vector<PlateSample> marked = samples;
    const int laser = out[static_cast<std::size_t>(k)].laser;
    for (std::size_t i = 0; i < marked.size(); ++i) marked[i].z = lasers[i] == laser ? 1.0F : 0.0F;
    SolvePlate(marked, plate, &x);
  });

  const Eigen::MatrixXd known = Eigen::MatrixXd::Identity(n, n) / (options.prior_mm * options.prior_mm);
  Eigen::MatrixXd normal = known, scatter = known;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), row(n);

  std::map<std::pair<int, int>, std::pair<Eigen::VectorXd, Eigen::MatrixXd>> patches;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlateSample& s = samples[i];
    const float z = HeightAt(solved, s.u, s.v);
    if (s.weight <= 0.0F || !std::isfinite(z)) continue;
    for (Eigen::Index k = 0; k < n; ++k)
      row[k] = -HeightAt(indicators[static_cast<std::size_t>(k)], s.u, s.v);
    const Eigen::Index own = index[lasers[i]];
    row[own] += 1.0;
    const double weight = s.weight;
    right[own] += weight * (s.z - z);
    normal.row(own) += weight * row.transpose();
    const std::pair<int, int> patch(static_cast<int>(std::floor(s.u * options.mm_per_px / options.patch_mm)),
                                    static_cast<int>(std::floor(s.v * options.mm_per_px / options.patch_mm)));
    auto& [g, h] =
        patches.try_emplace(patch, Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, n)).first->second;
    g += weight * (s.z - z) * row;
    h += weight * row * row.transpose();
  }
  normal = (0.5 * (normal + normal.transpose())).eval();
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd offsets = inverse * right;
  for (const auto& [patch, sums] : patches) {
    const Eigen::VectorXd g = sums.first - sums.second * offsets;
    scatter += g * g.transpose();
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
