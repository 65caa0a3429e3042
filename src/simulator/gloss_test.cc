// SPDX-License-Identifier: Apache-2.0
#include "simulator/gloss.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(Gloss, ShinesWhereAMirrorWouldAndOnlyThere) {
  SurfaceSample sample;
  sample.gloss = 0.04F;
  sample.shininess = 100.0F;
  const Eigen::Vector3d light(-100.0, 0.0, 300.0), mirror(100.0, 0.0, 300.0), aside(0.0, 200.0, 300.0);
  const double in_mirror = Highlight(sample, light, mirror);
  const double cosine = 3.0 / std::sqrt(10.0);  // of the angle of incidence
  const double fresnel = 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0);
  EXPECT_NEAR(in_mirror, fresnel * 108.0 / 8.0, 1e-6);
  EXPECT_LT(Highlight(sample, light, aside), 0.01 * in_mirror);
  sample.gloss = 0.0F;
  EXPECT_EQ(Highlight(sample, light, mirror), 0.0);
}

TEST(Gloss, GivesBackNoMoreLightThanItMirrors) {
  // Light from straight above: over the half sphere of directions, the light sent back, weighted by its
  // cosine, is close to the share that is mirrored.
  SurfaceSample sample;
  sample.gloss = 0.3F;
  sample.shininess = 200.0F;
  double sum = 0.0;
  constexpr int kSteps = 2000;
  const double pi = std::acos(-1.0);
  for (int i = 0; i < kSteps; ++i) {
    const double angle = (i + 0.5) * 0.5 * pi / kSteps;
    const Eigen::Vector3d eye(1e6 * std::sin(angle), 0.0, 1e6 * std::cos(angle));
    sum += Highlight(sample, {0.0, 0.0, 1e6}, eye) / pi * std::cos(angle) * 2.0 * pi * std::sin(angle) * 0.5 *
           pi / kSteps;
  }
  EXPECT_NEAR(sum, 0.3, 0.02);
}

}  // namespace
}  // namespace dorsum
