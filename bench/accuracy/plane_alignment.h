// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace dorsum::accuracy {

// A rotation and shift in the plane: b = rotation * a + shift.
struct PlaneAlignment {
  Eigen::Matrix2d rotation = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  std::vector<double> residuals;  // of the pairs that were kept, mm
};

// Least squares over pairs of points, with pairs beyond three times the median residual dropped twice: world
// frames may differ by where the board lay.
PlaneAlignment AlignInPlane(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b);

}  // namespace dorsum::accuracy
