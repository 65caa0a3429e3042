// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace dorsum {

// Soft spots a few millimetres wide, between -1 and 1, fixed in space: paper and cardboard are never even.
double Mottle(const Eigen::Vector3d& world);

}  // namespace dorsum
