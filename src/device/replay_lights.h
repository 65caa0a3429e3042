// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "captures/device_description.h"
#include "device/folder_frames.h"
#include "device/lights.h"

namespace dorsum {

// Lights before a capture folder (§3.3) that is shown again: under the LEDs the camera sees its bgHand, under
// laser K its stripesHandK, in the dark nothing. Any other set of lights, and a laser whose picture is
// missing, is an error. `frames` must outlive the lights.
std::unique_ptr<Lights> MakeReplayLights(const DeviceDescription& description, FolderFrames* frames);

}  // namespace dorsum
