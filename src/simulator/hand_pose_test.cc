// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_pose.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(HandPoseTest, VariesWithinItsLimits) {
  Rng rng(1);
  double most_yaw = 0, least_yaw = 0;
  for (int i = 0; i < 2000; ++i) {
    const HandPose pose = SampleHandPose(rng);
    EXPECT_LE(std::abs(pose.yaw), Radians(8));
    EXPECT_LE(pose.centre.cwiseAbs().maxCoeff(), 8.0);
    for (double spread : pose.spread) {
      EXPECT_GE(spread, Radians(4));
      EXPECT_LE(spread, Radians(12));
    }
    for (double flexion : pose.pip_flexion) EXPECT_TRUE(flexion >= 0 && flexion <= Radians(15));
    most_yaw = std::max(most_yaw, pose.yaw);
    least_yaw = std::min(least_yaw, pose.yaw);
  }
  EXPECT_GT(most_yaw, Radians(6));
  EXPECT_LT(least_yaw, Radians(-6));
}

TEST(HandPoseTest, SameSeedSamePose) {
  Rng a(7), b(7);
  EXPECT_EQ(SampleHandPose(a).thumb_roll, SampleHandPose(b).thumb_roll);
}

}  // namespace
}  // namespace dorsum
