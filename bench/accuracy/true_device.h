// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/result.h"
#include "geometry/calibration.h"

namespace dorsum::accuracy {

// The true camera and the true cones of a truth/device.json, as a perfect calibration would give them.
Result<DeviceGeometry> ReadTrueDevice(const std::filesystem::path& device_json);

}  // namespace dorsum::accuracy
