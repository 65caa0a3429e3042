// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.h"

namespace dorsum {

enum class Shape { kPlane, kSphere, kCylinder };

// A shape fitted to points by least squares of the distance to its surface.
struct ShapeFit {
  Shape shape = Shape::kPlane;
  Eigen::Vector3d center =
      Eigen::Vector3d::Zero();  // a point of the plane, the sphere's centre, a point of the axis; mm
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit: the plane's normal, the cylinder's axis
  double radius_mm = 0.0;                           // sphere, cylinder

  // Signed distance to the surface, mm; positive outside or above.
  double Distance(const Eigen::Vector3d& p) const;
};

// Gauss-Newton from a closed-form start. An error for too few points or points that do not determine the
// shape.
Result<ShapeFit> FitShape(Shape shape, const std::vector<Eigen::Vector3d>& points);

}  // namespace dorsum
