// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/context.h"
#include "geometry/mesh.h"
#include "surface/height_field.h"

namespace dorsum {

// 2.5D triangle mesh of a height field: one vertex per known height, two triangles per grid cell, none where
// the heights of a triangle differ by more than `max_slope_deg` allows over one cell (a depth jump). Vertices
// without a triangle are left out. Normals point up.
TriangleMesh MeshHeightField(const HeightField& field, double max_slope_deg = 75.0);

// Gives each point the normal of the nearest mesh vertex, or straight up where the mesh is further than
// `max_distance_mm`.
void AssignNormals(const TriangleMesh& mesh, double max_distance_mm, SurfacePoints* points,
                   const Context& context = {});

}  // namespace dorsum
