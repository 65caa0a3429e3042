// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_bodies.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

class HandBodiesTest : public testing::Test {
 protected:
  HandBodiesTest()
      : rng_(8), shape_(SampleHandShape(Sex::kMan, rng_)), skeleton_(BuildSkeleton(shape_, pose_)) {}

  Rng rng_;
  HandShape shape_;
  HandPose pose_;
  HandSkeleton skeleton_;
};

TEST_F(HandBodiesTest, FingersHaveTheirBreadthAndDepthAtTheJoints) {
  const HandBodies bodies = BuildBodies(shape_, pose_, skeleton_);
  for (int i = 0; i < 4; ++i) {
    const SweptBody::Place pip =
        bodies.fingers[i].Locate(skeleton_.fingers[i].pip + Eigen::Vector3d(0, 0, 0.5));
    // The smoothing of the profile takes a little off the joints, which are its widest places.
    EXPECT_NEAR(2 * pip.half_breadth, shape_.fingers[i].pip_breadth, 0.3);
    EXPECT_NEAR(pip.half_depth, 0.515 * shape_.fingers[i].pip_depth, 0.5);
    EXPECT_NEAR(bodies.fingers[i].Distance(skeleton_.fingers[i].tip), 0, 0.6);
  }
  EXPECT_NEAR(bodies.thumb.Distance(skeleton_.thumb.tip), 0, 0.5);
}

TEST_F(HandBodiesTest, JointsLieInsideTheFlesh) {
  const HandBodies bodies = BuildBodies(shape_, pose_, skeleton_);
  for (const FingerBones& bones : skeleton_.fingers) {
    double palm = 1e9;
    for (const BlendedBody& part : bodies.palm) palm = std::min(palm, part.body.Distance(bones.mcp));
    EXPECT_LT(palm, -5);
  }
}

TEST_F(HandBodiesTest, WebsReachFurtherWhenAsked) {
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d crotch = skeleton_.crotches[i];
    const double near = BuildWeb(shape_, skeleton_, i, 0).body.Distance(crotch);
    const double far = BuildWeb(shape_, skeleton_, i, 3).body.Distance(crotch);
    EXPECT_LT(far, near);
  }
}

TEST(AlongBodyTest, ProjectsOntoTheDirection) {
  EXPECT_DOUBLE_EQ(AlongBody({1, 1, 5}, {2, 0}, {4, 9, -3}), 3.0);
}

}  // namespace
}  // namespace dorsum
