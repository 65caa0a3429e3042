// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh.h"
#include "surface/height_field.h"
#include "surface/outline.h"
#include "surface/plate.h"
#include "surface/ray_field.h"

namespace dorsum {

// Triangulates heights over the image into a world mesh: each vertex lies on its pixel's camera ray. Cells at
// the outline are cut where the outline crosses them. No triangle where the surface is steeper against the
// camera's image plane than `max_slope_deg` (a depth jump), or where the lattice is not active. Normals point
// up.
TriangleMesh MeshLattice(const PlateLattice& lattice, const Outline& outline, const RayField& rays,
                         double max_slope_deg, const Context& context = {});

}  // namespace dorsum
