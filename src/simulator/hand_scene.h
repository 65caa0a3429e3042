// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "simulator/named_scene.h"
#include "simulator/scene.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Puts the hand that `name` asks for before the device, with all that its modifiers put on it. Shape and pose
// are drawn from the person and the visit only.
void AddHand(const VirtualDevice& device, const SceneName& name, std::uint64_t people_seed, Scene& scene);

}  // namespace dorsum
