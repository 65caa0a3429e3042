// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/result.h"
#include "geometry/mesh.h"
#include "surface/surface_point.h"

namespace dorsum {

// points.ply of DESIGN §4: binary little-endian, one vertex per stripe point with the properties
// x y z nx ny nz (float) laser (uchar) order (short) u v sigma (float).
Status WritePointsPly(const std::filesystem::path& path, const SurfacePoints& points);

// Binary little-endian triangle mesh: x y z (and nx ny nz if there are normals) as floats.
Status WriteMeshPly(const std::filesystem::path& path, const TriangleMesh& mesh);

// Reads back what WritePointsPly wrote, or any binary little-endian file with those properties.
Result<SurfacePoints> ReadPointsPly(const std::filesystem::path& path);

// Reads a binary little-endian triangle mesh with x y z and triangular faces; other properties are passed
// over.
Result<TriangleMesh> ReadMeshPly(const std::filesystem::path& path);

}  // namespace dorsum
