// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "geometry/rigid3.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Poses (world_from_board) of the chessboard for camera calibration (§3.2): the first flat on the backplane
// and centred on the origin, which is what fixes the world frame; the others raised and tilted by up to 25
// degrees all ways round, their squares wholly inside the picture. An error where the board is too large for
// the picture.
Result<std::vector<Rigid3>> DrawBoardPoses(const VirtualDevice& device, int count, std::uint64_t seed);

// The board laid flat at height z so that a laser's central stripe runs through its middle (§3.2), as well as
// a careful hand does it.
Rigid3 BoardOnStripe(const DiffractedFan& fan, double z, std::uint64_t seed);

}  // namespace dorsum
