// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_export.h"

#include <algorithm>
#include <memory>

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

#include "base/files.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

// Assimp's scene owns plain arrays and frees them itself.
std::unique_ptr<aiScene> ToScene(const TriangleMesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial() };
  scene->mNumMaterials = 1;
  auto* out = new aiMesh();
  out->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  out->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  out->mVertices = new aiVector3D[mesh.vertices.size()];
  out->mNormals = new aiVector3D[mesh.vertices.size()];
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3f v = mesh.vertices[i].cast<float>();
    const Eigen::Vector3f n =
        i < mesh.normals.size() ? Eigen::Vector3f(mesh.normals[i].cast<float>()) : Eigen::Vector3f::UnitZ();
    out->mVertices[i] = {v.x(), v.y(), v.z()};
    out->mNormals[i] = {n.x(), n.y(), n.z()};
  }
  out->mNumFaces = static_cast<unsigned>(mesh.faces.size());
  out->mFaces = new aiFace[mesh.faces.size()];
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    out->mFaces[i].mNumIndices = 3;
    out->mFaces[i].mIndices = new unsigned[3]{mesh.faces[i][0], mesh.faces[i][1], mesh.faces[i][2]};
  }
  scene->mMeshes = new aiMesh* [1] { out };
  scene->mNumMeshes = 1;
  scene->mRootNode = new aiNode();
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  scene->mRootNode->mNumMeshes = 1;
  return scene;
}

}  // namespace

Status ExportMesh(const std::filesystem::path& folder, const std::string& stem, const std::string& format,
                  const TriangleMesh& mesh) {
  const std::filesystem::path path = folder / (stem + "." + format);
  if (format == "ply") return WriteMeshPly(path, mesh);
  const auto& formats = MeshFormats();
  if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
    return UsageError("there is no mesh format '" + format + "'; choose from ply, stl, obj, glb");
  }
  if (mesh.faces.empty())
    return BadInput("the surface is empty, so there is no mesh to write to " + path.string());
  const auto scene = ToScene(mesh);
  Assimp::Exporter exporter;
  const std::string id = format == "stl" ? "stlb" : format == "glb" ? "glb2" : "objnomtl";
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), id);
  if (blob == nullptr)
    return Error{ErrorCode::kInternal, std::string("mesh export failed: ") + exporter.GetErrorString()};
  return WriteFile(path, {static_cast<const char*>(blob->data), blob->size});
}

}  // namespace dorsum
