// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "base/result.h"
#include "simulator/scene_modifiers.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// The device as it is during one capture: a laser off or dim, dust on a grating, more daylight, a camera that
// was knocked since the calibration. The world frame stays the one of the calibration.
VirtualDevice Disturb(VirtualDevice device, const SceneModifiers& modifiers, std::uint64_t seed);

// Whether Disturb() changes anything.
bool DisturbsDevice(const SceneModifiers& modifiers);

// A shift of the object within one capture.
struct Motion {
  Eigen::Vector3d offset_mm = Eigen::Vector3d::Zero();  // within the backplane
  int from_laser = 0;  // the first laser that sees the object at its new place
};
std::optional<Motion> MotionOf(const SceneModifiers& modifiers, int lasers, std::uint64_t seed);

// Refuses modifiers of lasers that the device does not have.
Status CheckLasers(const SceneModifiers& modifiers, int lasers);

}  // namespace dorsum
