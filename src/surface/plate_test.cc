// SPDX-License-Identifier: Apache-2.0
#include "surface/plate.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"

namespace dorsum {
namespace {

// Samples on a few columns of a 40 x 30 lattice.
std::vector<PlateSample> Columns(const std::function<double(double u, double v)>& z) {
  std::vector<PlateSample> out;
  for (const double u : {4.3, 13.1, 22.8, 33.4}) {
    for (double v = 2.0; v < 28.0; v += 1.0) {
      out.push_back({static_cast<float>(u), static_cast<float>(v), static_cast<float>(z(u, v)), 400.0F});
    }
  }
  return out;
}

const PlateOptions kExact{.mm_per_px = 1.0, .tension = 0.0, .max_iterations = 3000, .tolerance = 1e-7};

TEST(PlateTest, APlaneGoesOnBetweenAndBeyondTheSamples) {
  const auto plane = [](double u, double v) { return 12.0 + 0.3 * u - 0.2 * v; };
  PlateLattice l = FullLattice(40, 30, 1.0, 1.0F);
  SolvePlate(Columns(plane), kExact, &l);
  for (int r = 0; r < 30; ++r) {
    for (int c = 0; c < 40; ++c) EXPECT_NEAR(l.z(r, c), plane(c, r), 0.01) << c << " " << r;
  }
}

TEST(PlateTest, TheSolutionIsTheMinimum) {
  const auto wave = [](double u, double v) { return std::sin(0.3 * u) + 0.1 * std::cos(0.7 * v); };
  const std::vector<PlateSample> samples = Columns(wave);
  PlateLattice l = FullLattice(40, 30, 1.0, 2.0F);
  SolvePlate(samples, kExact, &l);
  const auto energy = [&](const PlateLattice& p) {
    double sum = 0.0;
    for (const PlateSample& s : samples) sum += s.weight * std::pow(s.z - HeightAt(p, s.u, s.v), 2);
    for (int r = 0; r < 30; ++r) {
      for (int c = 0; c < 40; ++c) {
        if (c > 0 && c < 39) sum += 2.0 * std::pow(p.z(r, c - 1) - 2.0F * p.z(r, c) + p.z(r, c + 1), 2);
        if (r > 0 && r < 29) sum += 2.0 * std::pow(p.z(r - 1, c) - 2.0F * p.z(r, c) + p.z(r + 1, c), 2);
        if (c < 39 && r < 29) {
          sum += 4.0 * std::pow(p.z(r, c) - p.z(r, c + 1) - p.z(r + 1, c) + p.z(r + 1, c + 1), 2);
        }
      }
    }
    return sum;
  };
  const double least = energy(l);
  for (const cv::Point at : {cv::Point(5, 5), cv::Point(20, 15), cv::Point(0, 0), cv::Point(39, 12)}) {
    for (const float step : {-0.02F, 0.02F}) {
      PlateLattice moved = l;
      moved.z = l.z.clone();
      moved.z(at) += step;
      EXPECT_GT(energy(moved), least);
    }
  }
}

TEST(PlateTest, OutsideTheSupportNoHeightIsKnown) {
  PlateLattice l = FullLattice(10, 10, 2.0, 1.0F);
  l.active(4, 4) = 0;
  l.z.setTo(3.0F);
  EXPECT_EQ(HeightAt(l, 3.0, 3.0), 3.0F);
  EXPECT_TRUE(std::isnan(HeightAt(l, 7.0, 7.0)));
  EXPECT_TRUE(std::isnan(HeightAt(l, -0.1, 3.0)));
  EXPECT_TRUE(std::isnan(HeightAt(l, 18.5, 3.0)));
  EXPECT_TRUE(std::isnan(HeightAt(l, std::nan(""), 3.0)));
}

TEST(PlateTest, AFinerLatticeTakesOverACoarserOne) {
  PlateLattice fine = FullLattice(21, 17, 1.5, 1.0F);
  for (int r = 0; r < 17; ++r) {
    for (int c = 12; c < 21; ++c) fine.active(r, c) = 0;
  }
  PlateLattice coarse = Coarsen(fine);
  EXPECT_EQ(coarse.step_px, 3.0);
  for (int r = 0; r < coarse.z.rows; ++r) {
    for (int c = 0; c < coarse.z.cols; ++c) {
      coarse.z(r, c) = coarse.active(r, c) != 0 ? static_cast<float>(2.0 * coarse.U(c) - coarse.V(r)) : 1e6F;
    }
  }
  Prolong(coarse, &fine);
  for (int r = 0; r < 17; ++r) {
    for (int c = 0; c < 12; ++c) EXPECT_NEAR(fine.z(r, c), 2.0 * fine.U(c) - fine.V(r), 1e-4);
  }
}

}  // namespace
}  // namespace dorsum
