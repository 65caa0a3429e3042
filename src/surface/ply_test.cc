// SPDX-License-Identifier: Apache-2.0
#include "surface/ply.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/random.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

SurfacePoints SomePoints() {
  SurfacePoints points(3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto k = static_cast<double>(i);
    SurfacePoint& p = points[i];
    p.position = {1.5 * k, -2.25, 30.125 + k};
    p.normal = {0.6F, 0.0F, 0.8F};
    p.laser = static_cast<std::uint8_t>(250 + i);
    p.order = static_cast<std::int16_t>(-300 * static_cast<int>(i));
    p.u = 100.5F;
    p.v = 2047.75F;
    p.sigma = 0.0625F;
  }
  return points;
}

TriangleMesh Square(bool normals) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1.5}, {0, 1, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  if (normals) mesh.normals.assign(4, Eigen::Vector3d::UnitZ());
  return mesh;
}

class PlyTest : public ::testing::Test {
 protected:
  std::string MeshMessage(const std::string& bytes) {
    EXPECT_TRUE(WriteFile(path_, bytes).ok());
    const auto mesh = ReadMeshPly(path_);
    if (mesh.ok()) return "(no error)";
    EXPECT_EQ(mesh.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(mesh.error().message, HasSubstr("x.ply"));
    return mesh.error().message;
  }
  std::string PointsMessage(const std::string& bytes) {
    EXPECT_TRUE(WriteFile(path_, bytes).ok());
    const auto points = ReadPointsPly(path_);
    if (points.ok()) return "(no error)";
    EXPECT_EQ(points.error().code, ErrorCode::kBadInput);
    return points.error().message;
  }
  std::string MeshBytes() {
    EXPECT_TRUE(WriteMeshPly(path_, Square(false)).ok());
    return ReadFile(path_).value();
  }
  std::string PointBytes() {
    EXPECT_TRUE(WritePointsPly(path_, SomePoints()).ok());
    return ReadFile(path_).value();
  }
  static std::string Replaced(std::string text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, old.size(), now);
  }
  TempFolder folder_;
  std::filesystem::path path_ = folder_ / "x.ply";
};

TEST_F(PlyTest, PointsComeBack) {
  ASSERT_TRUE(WritePointsPly(path_, SomePoints()).ok());
  const auto points = ReadPointsPly(path_);
  ASSERT_TRUE(points.ok()) << points.error().message;
  const SurfacePoints expected = SomePoints();
  ASSERT_EQ(points->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const SurfacePoint &p = (*points)[i], &e = expected[i];
    EXPECT_EQ(p.position, e.position);
    EXPECT_LT((p.normal - e.normal).norm(), 1e-6F);
    EXPECT_EQ(p.laser, e.laser);
    EXPECT_EQ(p.order, e.order);
    EXPECT_EQ(p.u, e.u);
    EXPECT_EQ(p.v, e.v);
    EXPECT_EQ(p.sigma, e.sigma);
  }
  ASSERT_TRUE(WritePointsPly(path_, {}).ok());
  EXPECT_TRUE(ReadPointsPly(path_).value().empty());
}

TEST_F(PlyTest, MeshesComeBackWithAndWithoutNormals) {
  for (const bool normals : {false, true}) {
    const TriangleMesh mesh = Square(normals);
    ASSERT_TRUE(WriteMeshPly(path_, mesh).ok());
    const auto back = ReadMeshPly(path_);
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(back->vertices, mesh.vertices);
    EXPECT_EQ(back->faces, mesh.faces);
  }
}

TEST_F(PlyTest, EveryTruncationIsAnError) {
  const std::string mesh = MeshBytes(), points = PointBytes();
  for (std::size_t n = 0; n < mesh.size(); n += 2)
    EXPECT_NE(MeshMessage(mesh.substr(0, n)), "(no error)") << n;
  for (std::size_t n = 0; n < points.size(); n += 3)
    EXPECT_NE(PointsMessage(points.substr(0, n)), "(no error)") << n;
}

TEST_F(PlyTest, OtherFormatsAndOtherFilesAreNamed) {
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "binary_little_endian", "ascii")), HasSubstr("ascii"));
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "binary_little_endian", "binary_big_endian")),
              HasSubstr("binary_big_endian"));
  EXPECT_THAT(MeshMessage("solid not a ply"), HasSubstr("not a PLY"));
  EXPECT_THAT(MeshMessage(""), HasSubstr("not a PLY"));
  EXPECT_THAT(PointsMessage(MeshBytes()), HasSubstr("'nx'"));
  EXPECT_THAT(PointsMessage(Replaced(PointBytes(), "element vertex", "element thing")),
              HasSubstr("vertices"));
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "property float x", "property quad x")), HasSubstr("header"));
}

TEST_F(PlyTest, HugeCountsEndAtTheFilesEndWithoutMemory) {
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "vertex 4", "vertex 199999999")), HasSubstr("cut off"));
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "vertex 4", "vertex 99999999999")), HasSubstr("header"));
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "vertex 4", "vertex -4")), HasSubstr("header"));
  // Rows without values never meet the file's end.
  EXPECT_THAT(MeshMessage(Replaced(MeshBytes(), "element face", "element empty 199999999\nelement face")),
              HasSubstr("header"));
}

TEST_F(PlyTest, AFaceWithoutItsListDoesNotRepeatTheLastOne) {
  EXPECT_NE(MeshMessage(
                "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nelement other 1\nproperty list uchar uchar a\nelement face 1\n"
                "property uchar b\nend_header\n" +
                std::string(12, '\0') + std::string("\3\0\0\0\0", 5)),
            "(no error)");
}

TEST_F(PlyTest, FacesMustBeTrianglesOfKnownVertices) {
  std::string bytes = MeshBytes();
  bytes[bytes.size() - 4] = 4;  // the last corner's index
  EXPECT_THAT(MeshMessage(bytes), HasSubstr("vertex that is not there"));
  bytes[bytes.size() - 1] = '\xff';  // a negative index
  EXPECT_THAT(MeshMessage(bytes), HasSubstr("vertex that is not there"));
  bytes = MeshBytes();
  bytes[bytes.size() - 13] = 2;  // corners of the last face
  EXPECT_THAT(MeshMessage(bytes), HasSubstr("not triangles"));
}

TEST_F(PlyTest, NotANumberIsRefused) {
  TriangleMesh mesh = Square(false);
  mesh.vertices[2].z() = std::nan("");
  ASSERT_TRUE(WriteMeshPly(path_, mesh).ok());
  EXPECT_THAT(ReadMeshPly(path_).error().message, HasSubstr("vertex 2"));
  SurfacePoints points = SomePoints();
  points[1].position.x() = INFINITY;
  ASSERT_TRUE(WritePointsPly(path_, points).ok());
  EXPECT_THAT(ReadPointsPly(path_).error().message, HasSubstr("point 1"));
}

TEST_F(PlyTest, ALaserThatFitsNoByteIsRefused) {
  // The same bytes, read as a float and so as nonsense.
  const std::string bytes =
      Replaced(PointBytes(), "property uchar laser", "property float laser") + std::string(64, '\x7f');
  EXPECT_NE(PointsMessage(bytes), "(no error)");
}

TEST_F(PlyTest, RandomDamageIsReadOrRefusedButNeverThrows) {
  Rng rng(11);
  const std::string mesh = MeshBytes(), points = PointBytes();
  int refused = 0;
  for (int i = 0; i < 120; ++i) {
    std::string bytes = i % 2 == 0 ? mesh : points;
    bytes[rng.Next() % bytes.size()] = static_cast<char>(rng.Next());
    EXPECT_NO_THROW(
        { refused += (i % 2 == 0 ? MeshMessage(bytes) : PointsMessage(bytes)) != "(no error)" ? 1 : 0; });
  }
  EXPECT_GT(refused, 20);
}

TEST_F(PlyTest, AFolderThatIsMissingCannotBeWrittenTo) {
  EXPECT_FALSE(WriteMeshPly(folder_ / "none/x.ply", Square(true)).ok());
  EXPECT_FALSE(ReadMeshPly(folder_ / "none/x.ply").ok());
}

}  // namespace
}  // namespace dorsum
