// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace dorsum {

// One reconstructed stripe point: a vertex of points.ply (DESIGN §4).
struct SurfacePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // world, mm
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   // unit, towards the camera's side
  std::uint8_t laser = 0;
  std::int16_t order = 0;
  float u = 0.0F, v = 0.0F;  // px, in the captured, distorted image
  float sigma = 0.0F;        // one standard deviation of z, mm
  std::int32_t segment = 0;  // of its laser; not written to disk
};

using SurfacePoints = std::vector<SurfacePoint>;

}  // namespace dorsum
