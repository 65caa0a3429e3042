// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "geometry/calibration.h"
#include "surface/laser_consistency.h"

namespace dorsum {

// The lasers are lit one after the other: what moves in between lies elsewhere in the later pictures. And
// what reaches out of the working volume gets orders that put every laser at another height. Either is an
// error that says so; `lasers` are each laser against the surface of all others.
Status CheckAgreement(const std::vector<LaserConsistency>& lasers, const DeviceGeometry& device);

}  // namespace dorsum
