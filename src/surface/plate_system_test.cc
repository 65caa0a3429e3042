// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_system.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"
#include "surface/plate_solver.h"
#include "surface/plate_stack.h"

namespace dorsum {
namespace {

// A lattice with a hole and a ragged border, wider than a block.
PlateLattice Ragged() {
  PlateLattice l = FullLattice(37, 9, 1.0, 2.0F);
  for (int c = 8; c < 12; ++c) l.active(4, c) = 0;
  for (int c = 30; c < 37; ++c) l.active(0, c) = 0;
  return l;
}

std::vector<PlateSample> Samples() {
  std::vector<PlateSample> samples;
  for (float u = 0.5F; u < 36.0F; u += 2.7F) {
    for (float v = 0.3F; v < 8.0F; v += 1.9F) samples.push_back({u, v, 0.1F * u * u - v, 30.0F});
  }
  return samples;
}

// The whole matrix; 1 on the diagonal where there is no node.
Eigen::MatrixXd WholeMatrix(const PlateSystem& s) {
  const auto n = static_cast<Eigen::Index>(s.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    matrix(i, i) = s.diagonal[k] > 0.0F ? static_cast<double>(s.diagonal[k]) : 1.0;
    for (std::size_t j = 0; j < 6; ++j) {
      const auto coefficient = static_cast<double>(s.upper[j][k]);
      if (coefficient == 0.0) continue;
      matrix(i, i + s.Offsets()[j]) = matrix(i + s.Offsets()[j], i) = coefficient;
    }
  }
  return matrix;
}

TEST(PlateSystem, ItsMatrixIsThePlatesEnergy) {
  PlateLattice l = Ragged();
  for (int r = 0; r < l.active.rows; ++r) {
    for (int c = 0; c < l.active.cols; ++c) {
      l.stiffness(r, c) =
          cv::Vec3f(1.0F + 0.1F * static_cast<float>(c), 2.0F, 3.0F - 0.2F * static_cast<float>(r));
      l.z(r, c) = std::sin(0.7F * static_cast<float>(c)) * std::cos(1.1F * static_cast<float>(r));
    }
  }
  const PlateSystem s({.mm_per_px = 0.5, .tension = 0.3}, l);
  const auto on = [&](int c, int r) {
    return c >= 0 && r >= 0 && c < l.active.cols && r < l.active.rows && l.active(r, c) != 0;
  };
  double energy = 0.0;
  for (int r = 0; r < l.active.rows; ++r) {
    for (int c = 0; c < l.active.cols; ++c) {
      if (!on(c, r)) continue;
      const auto z = [&](int x, int y) { return static_cast<double>(l.z(r + y, c + x)); };
      const cv::Vec3d k = l.stiffness(r, c) / 0.25F;
      if (on(c - 1, r) && on(c + 1, r)) energy += k[0] * std::pow(z(-1, 0) - 2.0 * z(0, 0) + z(1, 0), 2);
      if (on(c, r - 1) && on(c, r + 1)) energy += k[2] * std::pow(z(0, -1) - 2.0 * z(0, 0) + z(0, 1), 2);
      if (on(c + 1, r) && on(c, r + 1) && on(c + 1, r + 1))
        energy += 2.0 * k[1] * std::pow(z(0, 0) - z(1, 0) - z(0, 1) + z(1, 1), 2);
      if (on(c + 1, r)) energy += 0.3 * std::pow(z(0, 0) - z(1, 0), 2);
      if (on(c, r + 1)) energy += 0.3 * std::pow(z(0, 0) - z(0, 1), 2);
    }
  }
  const std::vector<float> x = s.Gather(l);
  const Eigen::VectorXd v =
      Eigen::Map<const Eigen::VectorXf>(x.data(), static_cast<Eigen::Index>(x.size())).cast<double>();
  EXPECT_NEAR(v.dot(WholeMatrix(s) * v) / energy, 1.0, 1e-5);
}

TEST(PlateSystem, ItsSolutionIsThatOfTheWholeMatrix) {
  const PlateLattice l = Ragged();
  const std::vector<PlateSample> samples = Samples();
  const std::vector<PlateGrid> grids = MakeGrids(l, 1.0, samples);
  const std::vector<float> weights(samples.size(), 30.0F);
  std::vector<float> heights;
  heights.reserve(samples.size());
  for (const PlateSample& p : samples) heights.push_back(p.z);
  std::vector<PlateSystem> systems;
  for (const PlateGrid& grid : grids) {
    PlateLattice one = grid.lattice;
    one.stiffness = cv::Mat3f(one.z.size(), cv::Vec3f::all(2.0F));
    systems.emplace_back(PlateOptions{.mm_per_px = 1.0}, one).AddSamples(grid.places, weights);
    systems.back().Finish();
  }
  std::vector<float> right(systems[0].size(), 0.0F);
  systems[0].AddHeights(heights, grids[0].places, weights, &right);
  const Eigen::VectorXd exact =
      WholeMatrix(systems[0])
          .ldlt()
          .solve(Eigen::Map<const Eigen::VectorXf>(right.data(), static_cast<Eigen::Index>(right.size()))
                     .cast<double>());
  for (const std::size_t count : {systems.size(), std::size_t{1}}) {
    std::vector<float> x(systems[0].size(), 0.0F);
    PlateSolver solver;
    const int iterations =
        solver.Solve(std::span<const PlateSystem>(systems).first(count), right, 300, 1e-7, &x);
    EXPECT_GT(iterations, 3);
    EXPECT_LT(iterations, 40);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (systems[0].diagonal[i] == 0.0F) continue;
      EXPECT_NEAR(x[i], exact[static_cast<Eigen::Index>(i)], 0.002) << i;
    }
  }
}

TEST(PlateSystem, ItsRunsHoldAllNodesAndNoEmptyBlock) {
  const PlateLattice l = Ragged();
  const PlateSystem s({.mm_per_px = 1.0}, l);
  std::vector<char> held(s.size(), 0);
  for (const auto& [begin, end] : s.runs()) {
    EXPECT_EQ(begin % PlateSystem::kBlock, 0U);
    EXPECT_EQ(end % PlateSystem::kBlock, 0U);
    for (std::size_t i = begin; i < end; ++i) held[i] = 1;
  }
  for (int r = 0; r < l.active.rows; ++r) {
    for (int c = 0; c < l.active.cols; ++c) EXPECT_TRUE(l.active(r, c) == 0 || held[s.At(c, r)] != 0);
  }
}

}  // namespace
}  // namespace dorsum
