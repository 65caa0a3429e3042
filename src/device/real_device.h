// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/result.h"
#include "device/device.h"

namespace dorsum {

// Opens the camera and the light controller that a description names. A device error where one does not
// answer, or where the controller lacks a channel that the description names.
Result<Device> OpenRealDevice(const std::string& name, DeviceDescription description);

}  // namespace dorsum
