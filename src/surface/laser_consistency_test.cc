// SPDX-License-Identifier: Apache-2.0
#include "surface/laser_consistency.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"
#include "surface/laser_offsets.h"

namespace dorsum {
namespace {

// Hills that fix a shift along all axes.
double Hills(double x, double y) {
  return std::abs(x) < 60.0 && std::abs(y) < 40.0 ? 25.0 + 4.0 * std::sin(0.12 * x) * std::cos(0.1 * y)
                                                  : std::nan("");
}

class LaserConsistencyTest : public ::testing::Test {
 protected:
  // Laser 1 of four sees the body after it moved.
  void Scan(const Eigen::Vector3d& shift) {
    Scene still = ScanBody(Hills, 4);
    const Scene moved =
        ScanBody([&](double x, double y) { return Hills(x - shift.x(), y - shift.y()) + shift.z(); }, 4);
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0F, 0.05F);
    SurfacePoints points;
    for (const SurfacePoint& p : still.points) {
      if (p.laser != 1) points.push_back(p);
    }
    for (const SurfacePoint& p : moved.points) {
      if (p.laser == 1) points.push_back(p);
    }
    samples_ = SamplesOf(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      samples_[i].z += noise(random);
      lasers_.push_back(points[i].laser);
    }
    mask_ = still.mask;
    lattice_ = FullLattice(161, 121, 4.0, 200.0F);
    for (int r = 0; r < 121; ++r) {
      for (int c = 0; c < 161; ++c) lattice_.active(r, c) = mask_(std::min(479, 4 * r), std::min(639, 4 * c));
    }
    lattice_.z.setTo(25.0F);
    plate_.mm_per_px = 0.47;
    SolvePlate(samples_, plate_, &lattice_);
  }
  std::vector<LaserConsistency> Compare() {
    const Outline outline(mask_, 4);
    const Rim rim({}, outline, {.mm_per_px = 0.47});
    const RayField rays(TestCamera(), cv::Rect(0, 0, 640, 480));
    return CompareLasers(samples_, lasers_, MakeGrids(lattice_, 0.47, samples_), plate_, rim, rays,
                         {.mm_per_px = 0.47});
  }
  std::vector<LaserOffset> Offsets() {
    SolvePlate(samples_, plate_, &lattice_);
    const std::vector<PlateGrid> grids = MakeGrids(lattice_, 0.47, samples_);
    std::vector<float> weights;
    weights.reserve(samples_.size());
    for (const PlateSample& s : samples_) weights.push_back(s.weight);
    PlateStack stack(plate_, grids);
    stack.SetSamples(weights, grids);
    return EstimateLaserOffsets(samples_, lasers_,
                                SolveIndicators(samples_, lasers_, stack, grids[0], plate_), grids[0],
                                {.mm_per_px = 0.47});
  }
  cv::Mat1b mask_;
  std::vector<PlateSample> samples_;
  std::vector<std::uint8_t> lasers_;
  PlateLattice lattice_;
  PlateOptions plate_;
};

TEST_F(LaserConsistencyTest, AMovedLaserStandsOutWithItsShift) {
  Scan({0.8, -0.5, 0.3});
  const std::vector<LaserConsistency> found = Compare();
  ASSERT_EQ(found.size(), 4U);
  EXPECT_NEAR(found[1].shift_mm.x(), 0.8, 0.25);
  EXPECT_NEAR(found[1].shift_mm.y(), -0.5, 0.2);
  EXPECT_NEAR(found[1].shift_mm.z(), 0.3, 0.1);
  EXPECT_GT(found[1].shift_significance, 8.0);
  EXPECT_GT(found[1].chi2, 2.0);
}

TEST_F(LaserConsistencyTest, ABodyAtRestShowsNoShift) {
  Scan(Eigen::Vector3d::Zero());
  for (const LaserConsistency& one : Compare()) {
    EXPECT_GT(one.samples, 1000);
    EXPECT_LT(one.shift_significance, 4.0);
    EXPECT_LT(one.shift_mm.norm(), 0.1);
    EXPECT_LT(std::abs(one.offset_mm), 0.02);
    EXPECT_LT(one.chi2, 1.8);
  }
}

TEST_F(LaserConsistencyTest, OffsetsComeBackRelativeToTheirMean) {
  Scan(Eigen::Vector3d::Zero());
  constexpr std::array<float, 4> kOffsets = {0.06F, -0.02F, -0.04F, 0.0F};
  for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].z += kOffsets[lasers_[i]];
  const std::vector<LaserOffset> found = Offsets();
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(found[k].laser, static_cast<int>(k));
    EXPECT_NEAR(found[k].mean_mm, kOffsets[k], 0.01);
    EXPECT_GE(found[k].sd_mm, 0.01);
    EXPECT_LT(found[k].sd_mm, 0.03);
  }
}

TEST_F(LaserConsistencyTest, OneLaserAloneHasNothingToBeComparedWith) {
  Scan(Eigen::Vector3d::Zero());
  lasers_.assign(lasers_.size(), 3);
  const std::vector<LaserConsistency> found = Compare();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].laser, 3);
  EXPECT_EQ(found[0].samples, 0);
  EXPECT_EQ(Offsets().front().mean_mm, 0.0);
}

}  // namespace
}  // namespace dorsum
