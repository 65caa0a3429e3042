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
  const cv::Mat3f s =
      LocalStiffness(coarse, FullLattice(59, 59, 2.0, 1.0F),
                     {.mm_per_px = 0.25, .least_curvature = 0.02, .correlation_area_mm2 = 2.0});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(s(30, 30)[i], 1.0 / (2.0 * 0.02 * 0.02), 1.0);
}

TEST(PlateStiffnessTest, CurvatureSoftensWhereItIs) {
  PlateLattice coarse = FullLattice(60, 60, 4.0, 1.0F);  // 1 mm per step
  for (int r = 0; r < 60; ++r) {
    for (int c = 0; c < 60; ++c)
      coarse.z(r, c) = c < 30 ? 0.0F : 0.05F * static_cast<float>((c - 30) * (c - 30));
  }
  const cv::Mat3f s = LocalStiffness(coarse, FullLattice(119, 119, 2.0, 1.0F),
                                     {.mm_per_px = 0.25, .correlation_area_mm2 = 1.0, .share_between = 1.0});
  EXPECT_NEAR(s(60, 100)[0], 1.0 / (0.1 * 0.1 + 0.015 * 0.015), 2.0);  // z'' = 0.1 on the right half
  EXPECT_NEAR(s(60, 100)[2], s(60, 100)[0], 1.0);                      // all alike
  EXPECT_GT(s(60, 10)[0], 20.0F * s(60, 100)[0]);
}

TEST(PlateStiffnessTest, ACylinderStaysStiffAlongItsAxis) {
  PlateLattice coarse = FullLattice(60, 60, 4.0, 1.0F);
  for (int r = 0; r < 60; ++r) {
    for (int c = 0; c < 60; ++c) coarse.z(r, c) = -0.04F * static_cast<float>((r - 30) * (r - 30));
  }
  const cv::Mat3f s =
      LocalStiffness(coarse, FullLattice(119, 119, 2.0, 1.0F), {.mm_per_px = 0.25, .share_between = 0.1});
  EXPECT_GT(s(60, 60)[0], 5.0F * s(60, 60)[2]);  // columns run along the axis
  EXPECT_GT(s(60, 60)[1], 5.0F * s(60, 60)[2]);
}

}  // namespace
}  // namespace dorsum
