// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "base/context.h"
#include "base/result.h"
#include "device/device.h"

namespace dorsum {

// The folder under `cache` for the calibration of the virtual device that was opened as `name`. What a
// device.toml says is part of it, and so is this program's version.
std::filesystem::path VirtualCalibrationDir(const std::filesystem::path& cache, const std::string& name);

// Takes the whole calibration series of a virtual device by itself, calibrates, and leaves an empty
// backplane: DIR/calibration.json. What is there already of the series is kept. A usage error for a device
// that is not virtual.
Result<std::filesystem::path> CalibrateVirtualDevice(Device& device, const std::filesystem::path& dir,
                                                     const Context& context);

}  // namespace dorsum
