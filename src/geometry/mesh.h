// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace dorsum {

// Triangles over shared vertices, world frame, mm; faces turn counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<Eigen::Vector3d> normals;  // unit, one per vertex, or empty
};

}  // namespace dorsum
