// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "geometry/camera.h"

namespace dorsum {

// Camera rays of a part of the image, tabulated so that a point on a ray costs an interpolation and not the
// inversion of the lens distortion. Between the nodes, 4 px apart, the error is below 1e-3 mm for lenses
// whose rays a hand's scanner can use.
class RayField {
 public:
  RayField(const Camera& camera, const cv::Rect& part);

  // World point at height z on the ray of an image point.
  Eigen::Vector3d At(double u, double v, double z) const;

  // dx/dz and dy/dz along the ray of an image point, and how they change from pixel to pixel.
  struct Slope {
    Eigen::Vector2d m, du, dv;
  };
  Slope SlopeAt(double u, double v) const;

  const Eigen::Vector3d& center() const { return center_; }

 private:
  Eigen::Vector3d center_;
  double u0_, v0_;
  cv::Mat_<cv::Vec2d> slope_;  // dx/dz and dy/dz along the ray
};

}  // namespace dorsum
