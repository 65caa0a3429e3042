// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "simulator/hand_skeleton.h"
#include "simulator/swept_body.h"

namespace dorsum {

struct BlendedBody {
  SweptBody body;
  double blend;  // mm: radius of the seam to what is already there
};

// The soft parts over the bones, in the hand's frame, before they are blended into one skin.
struct HandBodies {
  std::vector<BlendedBody> palm;     // forearm, palm, metacarpals, thenar, hypothenar, first interosseous
  std::array<SweptBody, 4> fingers;  // s = 0 at MCP
  SweptBody thumb;                   // s = 0 at CMC
};

HandBodies BuildBodies(const HandShape& shape, const HandPose& pose, const HandSkeleton& skeleton);

// The fold of skin i (0: thumb-index … 3: ring-little) that ends `beyond` mm past the skeleton's crotch.
BlendedBody BuildWeb(const HandShape& shape, const HandSkeleton& skeleton, int i, double beyond);

// Where s = 0 of a finger's body at DIP (thumb: IP) and at the tip, for details that sit on it.
double AlongBody(const Eigen::Vector3d& origin, const Eigen::Vector2d& direction,
                 const Eigen::Vector3d& point);

}  // namespace dorsum
