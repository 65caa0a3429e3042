// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/context.h"
#include "geometry/mesh.h"
#include "surface/height_field.h"

namespace dorsum {

// Heights of a mesh over a regular grid of the backplane, the highest where it overlaps itself; NaN
// elsewhere.
HeightField RasterizeMesh(const TriangleMesh& mesh, double pitch_mm, const Context& context = {});

}  // namespace dorsum
