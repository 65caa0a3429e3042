// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_skeleton.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

TEST(HandSkeletonTest, LinksKeepTheirLengths) {
  Rng rng(3);
  for (int k = 0; k < 50; ++k) {
    const HandShape shape = SampleHandShape(k % 2 ? Sex::kMan : Sex::kWoman, rng);
    const HandSkeleton skeleton = BuildSkeleton(shape, SampleHandPose(rng));
    for (int i = 0; i < 4; ++i) {
      const FingerShape& f = shape.fingers[i];
      const FingerBones& b = skeleton.fingers[i];
      // A bow of up to 2 mm to the side makes a link at most 0.1 mm longer.
      EXPECT_NEAR((b.pip - b.mcp).norm(), f.proximal_link, 0.1);
      EXPECT_NEAR((b.dip - b.pip).norm(), f.middle_link, 0.1);
      EXPECT_NEAR((b.tip - b.dip).norm(), f.distal_link, 0.1);
    }
    const ThumbBones& t = skeleton.thumb;
    EXPECT_NEAR((t.ip - t.mcp).norm(), shape.thumb.proximal_link, 1e-9);
    EXPECT_NEAR((t.tip - t.ip).norm(), shape.thumb.distal_link, 1e-9);
    EXPECT_GT(t.tip.y(), skeleton.fingers[0].mcp.y() + 10);  // the thumb of a right hand is at +y
  }
}

TEST(HandSkeletonTest, MiddleTipAndWristAreHandLengthApart) {
  Rng rng(4);
  for (int k = 0; k < 50; ++k) {
    const HandShape shape = SampleHandShape(Sex::kMan, rng);
    HandPose flat;
    flat.pip_flexion = flat.dip_flexion = {};
    const HandSkeleton skeleton = BuildSkeleton(shape, flat);
    // Fingers that slope down to the plane look a little shorter from above.
    EXPECT_NEAR(skeleton.fingers[1].tip.x() - skeleton.wrist.x(), shape.hand_length, 2.0);
    EXPECT_NEAR(skeleton.fingers[1].tip.x(), 0.5 * shape.hand_length, 2.0);
  }
}

TEST(HandSkeletonTest, PadsRestOnThePlane) {
  Rng rng(5);
  const HandShape shape = SampleHandShape(Sex::kWoman, rng);
  for (int k = 0; k < 20; ++k) {
    const HandSkeleton skeleton = BuildSkeleton(shape, SampleHandPose(rng));
    for (int i = 0; i < 4; ++i) {
      const FingerBones& b = skeleton.fingers[i];
      const double pad = b.dip.z() + 0.45 * (b.tip.z() - b.dip.z());
      EXPECT_NEAR(pad, 0.54 * shape.fingers[i].dip_depth - 0.5, 0.01);
      EXPECT_LT(b.tip.z(), b.mcp.z());
    }
  }
}

TEST(HandSkeletonTest, NarrowSpreadOpensUntilFingersAreApart) {
  Rng rng(6);
  for (int k = 0; k < 50; ++k) {
    const HandShape shape = SampleHandShape(Sex::kMan, rng);
    HandPose closed;
    closed.spread = {Radians(4), Radians(4), Radians(4)};
    const HandSkeleton skeleton = BuildSkeleton(shape, closed);
    for (int i = 0; i < 3; ++i) {
      const FingerBones &a = skeleton.fingers[i], &b = skeleton.fingers[i + 1];
      const double half = 0.5 * (shape.fingers[i].pip_breadth + shape.fingers[i + 1].pip_breadth);
      // Across, at the nearer of the two PIP joints.
      const FingerBones& nearer = a.pip.x() < b.pip.x() ? a : b;
      const FingerBones& other = a.pip.x() < b.pip.x() ? b : a;
      const Eigen::Vector2d offset = (nearer.pip - other.mcp).head<2>();
      const double across = std::abs(other.direction.x() * offset.y() - other.direction.y() * offset.x());
      EXPECT_GT(across - half, 0.6 * kFingerClearance);  // the line ignores up to 1.2 mm of bow
    }
  }
}

TEST(HandSkeletonTest, LeftMirrorsRight) {
  HandPose pose;
  pose.yaw = 0.1;
  pose.centre = {3, -4};
  HandPose mirrored = pose;
  mirrored.yaw = -0.1;
  mirrored.centre.y() = 4;
  const Eigen::Vector3d p(30, 12, 7);
  const Eigen::Vector3d right = WorldFromHand(Side::kRight, pose) * p;
  const Eigen::Vector3d left = WorldFromHand(Side::kLeft, mirrored) * p;
  EXPECT_NEAR((left - Eigen::Vector3d(right.x(), -right.y(), right.z())).norm(), 0, 1e-12);
}

TEST(HandSkeletonTest, OpenHandsAreBroader) {
  Rng rng(7);
  const HandShape shape = SampleHandShape(Sex::kMan, rng);
  HandPose closed, open;
  closed.spread = {0, 0, 0};
  open.spread = {Radians(12), Radians(12), Radians(12)};
  EXPECT_EQ(PalmBreadth(shape, closed), shape.hand_breadth);
  EXPECT_EQ(PalmBreadth(shape, open), shape.hand_breadth_open);
}

}  // namespace
}  // namespace dorsum
