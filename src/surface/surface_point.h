// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace dorsum {

// One reconstructed stripe point: a vertex of points.ply (DESIGN §4).
struct SurfacePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // world, mm
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();   // unit, towards the camera's side
  std::uint8_t laser = 0;
  std::int16_t order = 0;
  float u = 0.0F, v = 0.0F;  // px, in the captured, distorted image
  float sigma = 0.0F;        // one standard deviation of z, mm
  // The height that the image row alone gives, and the standard deviation that goes with it when rows are
  // taken as independent (stripes/stripes.h), mm. Where rows were not pooled: z and sigma. Not written to
  // disk.
  float row_z = 0.0F, row_sigma = 0.0F;
  std::int32_t segment = 0;  // of its laser; not written to disk
};

using SurfacePoints = std::vector<SurfacePoint>;

}  // namespace dorsum
