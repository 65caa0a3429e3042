// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"

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

TEST(PlateSystem, ItsSolutionIsThatOfTheWholeMatrix) {
  const PlateLattice l = Ragged();
  PlateSystem s({.mm_per_px = 1.0}, l);
  s.AddSamples(Samples(), l);
  s.Finish();
  const auto n = static_cast<Eigen::Index>(s.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    matrix(i, i) = s.diagonal[k] > 0.0F ? static_cast<double>(s.diagonal[k]) : 1.0;
    right[i] = static_cast<double>(s.right[k]);
    for (std::size_t j = 0; j < 6; ++j) {
      const auto coefficient = static_cast<double>(s.upper[j][k]);
      if (coefficient == 0.0) continue;
      matrix(i, i + s.Offsets()[j]) = matrix(i + s.Offsets()[j], i) = coefficient;
    }
  }
  const Eigen::VectorXd exact = matrix.ldlt().solve(right);
  std::vector<float> x(s.size(), 0.0F);
  EXPECT_GT(SolveByGradients(s, 3000, 1e-7, &x), 10);
  for (Eigen::Index i = 0; i < n; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], exact[i], 0.02) << i;
}

TEST(PlateSystem, ItsRunsHoldAllNodesAndNoEmptyBlock) {
  const PlateLattice l = Ragged();
  PlateSystem s({.mm_per_px = 1.0}, l);
  s.Finish();
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
