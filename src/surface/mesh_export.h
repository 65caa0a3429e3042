// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"

namespace dorsum {

// Mesh file formats by extension.
inline const std::vector<std::string>& MeshFormats() {
  static const std::vector<std::string> kFormats = {"ply", "stl", "obj", "glb"};
  return kFormats;
}

// Writes FOLDER/STEM.FORMAT: PLY by ourselves, STL (binary), OBJ and GLB by Assimp. Coordinates stay mm, z
// up.
Status ExportMesh(const std::filesystem::path& folder, const std::string& stem, const std::string& format,
                  const TriangleMesh& mesh);

}  // namespace dorsum
