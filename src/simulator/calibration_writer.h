// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/context.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// The whole calibration series of §3.2 and DESIGN §4 of a device: chessboards, both distances of each laser,
// first estimates, reference images, boxes of known height, and setup.json.
Status WriteCalibrationSeries(const VirtualDevice& device, const std::filesystem::path& dir,
                              const Context& context);

}  // namespace dorsum
