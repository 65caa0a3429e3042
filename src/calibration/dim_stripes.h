// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "calibration/bundle_problem.h"

namespace dorsum {

// Orders of one laser that the empty backplane hardly shows, and stretches of a stripe there that are missing
// or dim against the stripes beside it: an order that the grating makes weak, or a dirty spot on it. One
// phrase each. `height_px` is the image's.
std::vector<std::string> FindDimStripes(const std::vector<SheetPoint>& points, int laser, int height_px);

}  // namespace dorsum
