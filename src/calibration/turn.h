// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace dorsum {

// The rotation by a turn vector (axis times angle, rad): Rodrigues' formula.
Eigen::Matrix3d TurnMatrix(const Eigen::Vector3d& turn);

// How a rotation grows with its turn vector, its right Jacobian: TurnMatrix(turn + d) is TurnMatrix(turn)
// TurnMatrix(TurnGrowth(turn) d) for small d.
Eigen::Matrix3d TurnGrowth(const Eigen::Vector3d& turn);

// The matrix that takes the cross product: Cross(a) b = a x b.
Eigen::Matrix3d Cross(const Eigen::Vector3d& a);

}  // namespace dorsum
