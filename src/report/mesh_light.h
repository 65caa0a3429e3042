// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/mesh.h"
#include "report/mesh_tracer.h"

namespace dorsum {

// One unit normal per vertex: the mesh's own, or the mean over the faces weighted by their area.
std::vector<Eigen::Vector3d> VertexNormals(const TriangleMesh& mesh);

// How much of the sky each vertex sees within `reach_mm`, 0 to 1: hollows are darker, which is what makes
// knuckles and tendons readable. The backplane z = 0 blocks the sky too.
std::vector<float> VertexSky(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                             const MeshTracer& tracer, double reach_mm, const Context& context);

// The soft shadow of a mesh on the backplane z = 0: how much sky a grid of places sees, from `origin_mm` on.
struct FloorShadow {
  Eigen::Vector2d origin_mm = Eigen::Vector2d::Zero();
  double pitch_mm = 2.0;
  cv::Mat1f sky;
  double At(double x, double y) const;  // between the places; 1 outside the grid
};
FloorShadow ShadeFloor(const TriangleMesh& mesh, const MeshTracer& tracer, double reach_mm,
                       const Context& context);

}  // namespace dorsum
