// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_export.h"

#include <string>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/temp_folder_test.h"
#include "surface/height_mesh.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

// A bowl of 10 x 8 grid points.
TriangleMesh Bowl() {
  HeightField field;
  field.origin_mm = {-20.0, 10.0};
  field.z = cv::Mat1f(8, 10);
  for (int r = 0; r < 8; ++r) {
    for (int c = 0; c < 10; ++c) field.z(r, c) = static_cast<float>(30.0 + 0.01 * (r * r + c * c));
  }
  return MeshHeightField(field);
}

class MeshExportTest : public ::testing::TestWithParam<std::string> {
 protected:
  TempFolder folder_;
};

TEST_P(MeshExportTest, OtherProgramsReadAllFacesAtTheirPlaces) {
  const TriangleMesh mesh = Bowl();
  const Status status = ExportMesh(folder_.path(), "surface", GetParam(), mesh);
  ASSERT_TRUE(status.ok()) << status.error().message;
  const std::filesystem::path path = folder_ / ("surface." + GetParam());
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_PreTransformVertices);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  std::size_t faces = 0;
  Eigen::Vector3d low(1e9, 1e9, 1e9), high(-1e9, -1e9, -1e9);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& m = *scene->mMeshes[i];
    faces += m.mNumFaces;
    for (unsigned k = 0; k < m.mNumVertices; ++k) {
      const Eigen::Vector3d p(m.mVertices[k].x, m.mVertices[k].y, m.mVertices[k].z);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (unsigned k = 0; k < m.mNumFaces; ++k) {
      const aiFace& f = m.mFaces[k];
      ASSERT_EQ(f.mNumIndices, 3U);
      const aiVector3D a = m.mVertices[f.mIndices[1]] - m.mVertices[f.mIndices[0]];
      const aiVector3D b = m.mVertices[f.mIndices[2]] - m.mVertices[f.mIndices[0]];
      EXPECT_GT(a.x * b.y - a.y * b.x, 0.0F) << "faces look up";
    }
  }
  EXPECT_EQ(faces, mesh.faces.size());
  EXPECT_LT((low - Eigen::Vector3d(-20.0, 10.0, 30.0)).norm(), 1e-3);
  EXPECT_LT((high - Eigen::Vector3d(-15.5, 13.5, 31.3)).norm(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshExportTest, ::testing::ValuesIn(MeshFormats()),
                         [](const auto& format) { return format.param; });

TEST(MeshExport, AnUnknownFormatSaysWhichThereAre) {
  const TempFolder folder;
  const Status status = ExportMesh(folder.path(), "surface", "step", Bowl());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUsage);
  EXPECT_THAT(status.error().message, HasSubstr("ply, stl, obj, glb"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(MeshExport, AnEmptyMeshIsAnErrorAndLeavesNoFile) {
  const TempFolder folder;
  for (const char* format : {"stl", "obj", "glb"}) {
    const Status status = ExportMesh(folder.path(), "surface", format, {});
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(MeshExport, AMissingFolderIsAnError) {
  const TempFolder folder;
  for (const std::string& format : MeshFormats()) {
    EXPECT_FALSE(ExportMesh(folder / "none", "surface", format, Bowl()).ok());
  }
}

}  // namespace
}  // namespace dorsum
