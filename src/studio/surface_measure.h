// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "geometry/mesh.h"

namespace dorsum {

// A place on a mesh: it lies in this face.
struct MeshPlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // world, mm
  std::uint32_t face = 0;
};

struct SurfaceDistance {
  double straight_mm = 0.0, along_mm = 0.0;
  std::vector<Eigen::Vector3d> path;  // over the surface, from the first place to the second
};

// The shortest way over the mesh, from above: a way that is really there, at most a few thousandths longer
// than the shortest. A* from edge to edge over the faces, through three places of each edge, then through
// nine near the way that this gave; then each crossing slides along its edge to where the two faces,
// unfolded, let the way run straight. An error where no way joins the two places.
Result<SurfaceDistance> MeasureAlong(const TriangleMesh& mesh, const MeshPlace& from, const MeshPlace& to,
                                     const Context& context);

// One curve of a section: s is the distance along the line, z the height, both mm.
using SectionCurve = std::vector<Eigen::Vector2d>;
struct Section {
  std::vector<SectionCurve> curves;   // each runs without a gap
  std::vector<Eigen::Vector2d> dots;  // of a section through points
  double length_mm = 0.0;             // s of the line's second end; its first end has s = 0
};

// Where the vertical plane through two places (mm) cuts the mesh; over the whole mesh, beyond both places.
// An error where they stand one above the other.
Result<Section> CutMesh(const TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b);
// The same for points: those that lie no further than `reach_mm` from the plane.
Result<Section> CutPoints(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, double reach_mm);

}  // namespace dorsum
