// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_pieces.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stripes/joint_scene_test.h"

namespace dorsum {
namespace {

// Pieces of one stripe of laser 0 between rows 100 and 300.
std::vector<JointPiece> Cut(const std::function<double(int row)>& column) {
  const DeviceGeometry device = FanDevice(1);
  std::vector<LaserStripes> stripes(1);
  AddStripe(stripes.data(), 100, 300, column);
  return CutPieces(stripes, DeviceOrders(device), {}, {});
}

bool BeginsNear(const std::vector<JointPiece>& pieces, int point, int slack) {
  for (const JointPiece& p : pieces) {
    if (!p.follows && p.first > 0 && std::abs(p.first - point) <= slack) return true;
  }
  return false;
}

TEST(JointPieces, CoverEveryPointOnce) {
  std::int32_t next = 0;
  for (const JointPiece& p : Cut([](int row) { return 400.0 + 0.1 * row; })) {
    EXPECT_EQ(p.first, next);
    next += p.count;
  }
  EXPECT_EQ(next, 200);
}

TEST(JointPieces, BeginWhereAStripeStepsToAnotherSurface) {
  EXPECT_TRUE(BeginsNear(Cut([](int row) { return row < 217 ? 500.0 : 501.8; }), 117, 1));
}

TEST(JointPieces, BeginWhereAStripeBends) {
  EXPECT_TRUE(BeginsNear(Cut([](int row) { return 500.0 + std::max(0, row - 217) * 0.6; }), 117, 3));
}

TEST(JointPieces, AreNotCutForAReasonWhereAStripeIsSmooth) {
  for (const JointPiece& p : Cut([](int row) { return 500.0 + 1e-3 * (row - 200) * (row - 200); })) {
    EXPECT_TRUE(p.follows || p.first == 0) << p.first;
  }
}

TEST(JointPieces, BeginWhereAStripeClimbsSlowlyOffTheBackplane) {
  const DeviceGeometry device = FanDevice(1);
  const auto pieces = Cut([&](int row) {
    return *ColumnOf(device, device.lasers[0], 2, row, row < 217 ? 0.0 : 0.1 * (row - 217));
  });
  EXPECT_TRUE(BeginsNear(pieces, 117, 10));
}

TEST(JointPieces, KnowAllHeightsOfTheWorkingVolume) {
  const DeviceGeometry device = FanDevice(1);
  for (const double z : {1.0, 20.0, 79.0}) {
    const auto pieces = Cut([&](int row) { return *ColumnOf(device, device.lasers[0], 2, row, z); });
    for (const JointPiece& p : pieces) {
      const auto k = p.Candidate(2);
      ASSERT_TRUE(k);
      for (std::size_t i = 0; i < p.samples.size(); ++i) EXPECT_NEAR(p.Heights(i)[*k], z, 0.02);
      for (int a = 0; a + 1 < p.candidates; ++a) {
        if (std::isnan(p.Heights(0)[a]) || std::isnan(p.Heights(0)[a + 1])) {
          continue;
        }
        EXPECT_LT(p.Heights(0)[a], p.Heights(0)[a + 1]);
      }
    }
  }
}

}  // namespace
}  // namespace dorsum
