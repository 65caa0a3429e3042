// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "captures/series_plan.h"
#include "simulator/scene.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// What a careful person puts before the device for a step of the calibration series. Its place is drawn from
// the device's seed and the step, so that it is the same in a folder and at the live device. An error where
// the chessboard does not fit into the picture.
Result<Scene> BuildSeriesScene(const VirtualDevice& device, const SeriesStep& step);

// The seed of a picture's noise, by its name in the calibration folder.
std::uint64_t SeriesPictureSeed(const VirtualDevice& device, const std::string& name);

}  // namespace dorsum
