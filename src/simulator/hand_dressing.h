// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "simulator/hand_pose.h"
#include "simulator/hand_shape.h"
#include "simulator/scene.h"

namespace dorsum {

struct PosedHand {
  HandShape shape;
  Side side = Side::kRight;
  HandPose pose;
};

// What people wear. Cloth and metal count as grey (Material::kGrey): other objects.
ScenePart Ring(const PosedHand& hand);    // 5 mm wide, 1.1 mm thick, at the root of the ring finger
ScenePart Sleeve(const PosedHand& hand);  // 3 mm of folded cloth from the wrist on

// What changes the look of a hand's skin; its shape stays. `skin` is the hand's own part.
void Brighten(double factor, ScenePart& skin);
void MakeWet(std::uint64_t seed, ScenePart& skin);                          // in patches of about 2 cm
void VarnishNails(const PosedHand& hand, ScenePart& skin);                  // bright and glossy
void GrowHair(const PosedHand& hand, std::uint64_t seed, ScenePart& skin);  // 0.08 mm thick, 6 to 14 mm long

}  // namespace dorsum
