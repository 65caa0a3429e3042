// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_export.h"

#include <algorithm>

#include "surface/mesh_export.h"
#include "surface/ply.h"

namespace dorsum {

Status ExportSurface(const Reconstruction& surface, const std::filesystem::path& path) {
  std::string format = path.extension().string();
  if (!format.empty()) format.erase(0, 1);
  const auto& formats = MeshFormats();
  if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
    return UsageError("'" + path.filename().string() +
                      "' does not say which file to write; end it with .ply, .obj, .stl, .glb or .png");
  }
  if (surface.mesh.faces.empty()) {
    if (surface.points.empty()) return UsageError("there is no surface to export; scan or open one first");
    if (format != "ply") {
      return UsageError("only points are open and ." + format + " files hold meshes; export them as .ply");
    }
    return WritePointsPly(path, surface.points);
  }
  return ExportMesh(path.parent_path(), path.stem().string(), format, surface.mesh);
}

}  // namespace dorsum
