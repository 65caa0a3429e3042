// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/result.h"
#include "jobs/reconstruct.h"

namespace dorsum {

// Writes a surface as the extension says: ply, obj, stl or glb of the mesh; ply of the points where there is
// no mesh.
Status ExportSurface(const Reconstruction& surface, const std::filesystem::path& path);

}  // namespace dorsum
