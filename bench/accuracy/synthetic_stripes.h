// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "accuracy/results.h"
#include "base/context.h"

namespace dorsum::accuracy {

// Many simultaneous stripes in one image of 1600 x 1200 px without optics, by which extractors of other
// scanners were compared: 40 clean, 40 dim and 80 saturated ones of sd 2 px, reflectance 10 to 100 %, two
// humps, matched within 3 px per row. `seed` names the images. One capture for each case, with the figures
// recall, false, rmse_px, bound_ratio (over the Cramér-Rao bound with centre, width, amplitude and background
// unknown), sigma_ratio, all of single rows, and pooled_rmse_px.
DeviceResult MeasureSyntheticStripes(std::uint64_t seed, const Context& context);

// What is asked beside what was reached.
std::string SyntheticTable(const DeviceResult& result);

}  // namespace dorsum::accuracy
