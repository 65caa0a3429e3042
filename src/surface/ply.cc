// SPDX-License-Identifier: Apache-2.0
#include "surface/ply.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "base/files.h"
#include "surface/ply_reader.h"

namespace dorsum {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY files are written little-endian");

// A header and room for the `bytes` of its elements, filled from front to back.
class PlyText {
 public:
  PlyText(std::string header, std::size_t bytes) : text_(std::move(header)), at_(text_.size()) {
    text_.resize(at_ + bytes);
  }

  template <class T>
  void Put(T value) {
    std::memcpy(text_.data() + at_, &value, sizeof(T));
    at_ += sizeof(T);
  }
  void PutVector(const Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) Put(static_cast<float>(v[i]));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t at_;
};

constexpr std::size_t kVectorBytes = 3 * sizeof(float);

}  // namespace

Status WritePointsPly(const std::filesystem::path& path, const SurfacePoints& points) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment Dorsum: world frame, mm; u v in pixels of the captured "
      "image\n"
      "element vertex " +
      std::to_string(points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float "
      "ny\nproperty float nz\n"
      "property uchar laser\nproperty short order\nproperty float u\nproperty float v\nproperty float "
      "sigma\nend_header\n";
  PlyText out(header,
              points.size() * (3 * kVectorBytes + sizeof(SurfacePoint::laser) + sizeof(SurfacePoint::order)));
  for (const SurfacePoint& p : points) {
    out.PutVector(p.position);
    out.PutVector(p.normal.cast<double>());
    out.Put(p.laser);
    out.Put(p.order);
    out.Put(p.u);
    out.Put(p.v);
    out.Put(p.sigma);
  }
  return WriteFile(path, out.text());
}

Status WriteMeshPly(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const bool normals = mesh.normals.size() == mesh.vertices.size() && !mesh.normals.empty();
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment Dorsum: world frame, mm\nelement vertex " +
      std::to_string(mesh.vertices.size()) + "\nproperty float x\nproperty float y\nproperty float z\n" +
      (normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") + "element face " +
      std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  PlyText out(header, mesh.vertices.size() * (normals ? 2 : 1) * kVectorBytes +
                          mesh.faces.size() * (sizeof(std::uint8_t) + 3 * sizeof(std::int32_t)));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    out.PutVector(mesh.vertices[i]);
    if (normals) out.PutVector(mesh.normals[i]);
  }
  for (const auto& f : mesh.faces) {
    out.Put(std::uint8_t{3});
    for (const std::uint32_t i : f) out.Put(static_cast<std::int32_t>(i));
  }
  return WriteFile(path, out.text());
}

Result<SurfacePoints> ReadPointsPly(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(PlyReader reader, PlyReader::Open(path));
  if (reader.elements().empty() || reader.elements().front().name != "vertex") {
    return reader.Damaged("it does not begin with vertices");
  }
  const PlyElement vertex = reader.elements().front();
  DORSUM_ASSIGN_OR_RETURN(const auto c, reader.Columns(vertex, {"x", "y", "z", "nx", "ny", "nz", "laser",
                                                                "order", "u", "v", "sigma"}));
  SurfacePoints points;
  std::vector<double> row, list;
  for (std::size_t i = 0; i < vertex.count; ++i) {
    DORSUM_RETURN_IF_ERROR(reader.ReadRow(vertex, &row, &list));
    SurfacePoint p;
    p.position = {row[c[0]], row[c[1]], row[c[2]]};
    p.normal = Eigen::Vector3d(row[c[3]], row[c[4]], row[c[5]]).cast<float>();
    if (!p.position.allFinite()) return reader.Damaged("point " + std::to_string(i) + " is not a number");
    if (!(row[c[6]] >= 0.0 && row[c[6]] <= 255.0 && std::abs(row[c[7]]) <= 32767.0)) {
      return reader.Damaged("point " + std::to_string(i) + " has no such laser or order");
    }
    p.laser = static_cast<std::uint8_t>(row[c[6]]);
    p.order = static_cast<std::int16_t>(row[c[7]]);
    p.u = static_cast<float>(row[c[8]]);
    p.v = static_cast<float>(row[c[9]]);
    p.sigma = static_cast<float>(row[c[10]]);
    points.push_back(p);
  }
  return points;
}

Result<TriangleMesh> ReadMeshPly(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(PlyReader reader, PlyReader::Open(path));
  TriangleMesh mesh;
  std::vector<double> row, list;
  for (const PlyElement& element : reader.elements()) {
    std::vector<std::size_t> c;
    if (element.name == "vertex") {
      DORSUM_ASSIGN_OR_RETURN(c, reader.Columns(element, {"x", "y", "z"}));
    }
    for (std::size_t i = 0; i < element.count; ++i) {
      DORSUM_RETURN_IF_ERROR(reader.ReadRow(element, &row, &list));
      if (element.name == "vertex") {
        mesh.vertices.emplace_back(row[c[0]], row[c[1]], row[c[2]]);
        if (!mesh.vertices.back().allFinite())
          return reader.Damaged("vertex " + std::to_string(i) + " is not a number");
      } else if (element.name == "face") {
        if (list.size() != 3) return reader.Damaged("it has faces that are not triangles");
        std::array<std::uint32_t, 3> face{};
        for (std::size_t k = 0; k < 3; ++k) {
          if (list[k] < 0.0 || list[k] >= static_cast<double>(mesh.vertices.size())) {
            return reader.Damaged("a face names a vertex that is not there");
          }
          face[k] = static_cast<std::uint32_t>(list[k]);
        }
        mesh.faces.push_back(face);
      }
    }
  }
  return mesh;
}

}  // namespace dorsum
