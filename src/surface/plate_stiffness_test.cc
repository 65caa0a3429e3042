// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_stiffness.h"

#include <gtest/gtest.h>

#include "surface/fusion_scene_test.h"

namespace dorsum {
namespace {

TEST(PlateStiffnessTest, APlaneIsAsStiffAsItGets) {
  PlateLattice coarse = FullLattice(30, 30, 4.0, 1.0F);
  for (int r = 0; r < 30; ++r) {
    for (int c = 0; c < 30; ++c) coarse.z(r, c) = 0.3F * static_cast<float>(c) - 0.2F * static_cast<float>(r);
  }
  const cv::Mat1f s =
      LocalStiffness(coarse, FullLattice(59, 59, 2.0, 1.0F),
                     {.mm_per_px = 0.25, .least_curvature = 0.02, .correlation_area_mm2 = 2.0});
  EXPECT_NEAR(s(30, 30), 1.0 / (2.0 * 0.02 * 0.02), 1.0);
}

TEST(PlateStiffnessTest, CurvatureSoftensWhereItIs) {
  PlateLattice coarse = FullLattice(60, 60, 4.0, 1.0F);  // 1 mm per step
  for (int r = 0; r < 60; ++r) {
    for (int c = 0; c < 60; ++c)
      coarse.z(r, c) = c < 30 ? 0.0F : 0.05F * static_cast<float>((c - 30) * (c - 30));
  }
  const cv::Mat1f s = LocalStiffness(coarse, FullLattice(119, 119, 2.0, 1.0F), {.mm_per_px = 0.25});
  EXPECT_NEAR(s(60, 100), 1.0 / (0.1 * 0.1 + 0.015 * 0.015), 2.0);  // z'' = 0.1 on the right half
  EXPECT_GT(s(60, 10), 20.0F * s(60, 100));
}

}  // namespace
}  // namespace dorsum
