// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/context.h"
#include "base/result.h"
#include "device/device.h"

namespace dorsum {

// Opens the light controller and the camera that a description names. A camera that is a folder needs no
// controller: the capture in it is shown again, each picture under its own light (device/replay_lights.h). A
// device error where one does not answer, or where the controller lacks a channel that is needed.
Result<Device> OpenRealDevice(const std::string& name, DeviceDescription description, const Context& context);

}  // namespace dorsum
