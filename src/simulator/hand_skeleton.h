// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "simulator/hand_pose.h"
#include "simulator/hand_shape.h"

namespace dorsum {

// Joint centres in mm in the hand's frame, always of a right hand: origin on the plane, midway between the
// wrist crease and the tip of the middle finger; x along the hand towards the fingers, y towards the thumb, z
// up.
struct FingerBones {
  Eigen::Vector3d carpal;  // base of the metacarpal
  Eigen::Vector3d mcp, pip, dip;
  Eigen::Vector3d tip;        // end of the skin
  Eigen::Vector2d direction;  // of the finger, seen from above; unit
};

struct ThumbBones {
  Eigen::Vector3d cmc, mcp, ip, tip;
};

struct HandSkeleton {
  std::array<FingerBones, 4> fingers;
  ThumbBones thumb;
  Eigen::Vector3d wrist;                    // centre of the section at the wrist crease
  Eigen::Vector2d forearm;                  // unit: from the wrist towards the elbow
  std::array<Eigen::Vector3d, 4> crotches;  // where the webs end; thumb-index first
};

inline constexpr double kFingerClearance =
    3.0;  // mm: least gap between neighbouring fingers beyond their web

// Breadth over the metacarpals for this pose: closed hands are narrower than open ones (Hsiao 2015).
double PalmBreadth(const HandShape& shape, const HandPose& pose);

// Lays the bones so that the finger pads and the heel of the hand rest on the plane. Where the pose would let
// two fingers touch, the outer one moves out until they are kFingerClearance apart.
HandSkeleton BuildSkeleton(const HandShape& shape, const HandPose& pose);

// World from the hand's frame; of a left hand, y is mirrored first.
Eigen::Affine3d WorldFromHand(Side side, const HandPose& pose);

}  // namespace dorsum
