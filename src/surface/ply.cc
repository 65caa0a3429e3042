// SPDX-License-Identifier: Apache-2.0
#include "surface/ply.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include "base/files.h"

namespace dorsum {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY files are written little-endian");

template <class T>
void Append(std::string* out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out->append(bytes, sizeof(T));
}

void AppendVector(std::string* out, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) Append(out, static_cast<float>(v[i]));
}

struct Property {
  std::string name, type;
  bool is_list = false;
  std::string count_type;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

std::size_t SizeOf(const std::string& type) {
  static const std::map<std::string, std::size_t> kSizes = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto it = kSizes.find(type);
  return it == kSizes.end() ? 0 : it->second;
}

template <class T>
double Load(const char* p) {
  T value;
  std::memcpy(&value, p, sizeof(T));
  return static_cast<double>(value);
}

double LoadAs(const std::string& type, const char* p) {
  if (type == "float" || type == "float32") return Load<float>(p);
  if (type == "double" || type == "float64") return Load<double>(p);
  if (type == "char" || type == "int8") return Load<std::int8_t>(p);
  if (type == "uchar" || type == "uint8") return Load<std::uint8_t>(p);
  if (type == "short" || type == "int16") return Load<std::int16_t>(p);
  if (type == "ushort" || type == "uint16") return Load<std::uint16_t>(p);
  if (type == "int" || type == "int32") return Load<std::int32_t>(p);
  return Load<std::uint32_t>(p);
}

// Walks through a PLY file's elements; every read is checked against the end of the file.
class PlyReader {
 public:
  static Result<PlyReader> Open(const std::filesystem::path& path) {
    PlyReader reader;
    reader.name_ = path.string();
    DORSUM_ASSIGN_OR_RETURN(reader.bytes_, ReadFile(path));
    DORSUM_RETURN_IF_ERROR(reader.ReadHeader());
    return reader;
  }

  const std::vector<Element>& elements() const { return elements_; }

  Error Damaged(const std::string& what) const {
    return BadInput(name_ + ": " + what + "; write the file again");
  }

  // Values of the next row of scalars by property name; the last one of a list property is put into `list`.
  Status ReadRow(const Element& element, std::vector<double>* scalars, std::vector<double>* list) {
    scalars->clear();
    list->clear();
    for (const Property& p : element.properties) {
      std::size_t count = 1;
      if (p.is_list) {
        if (at_ + SizeOf(p.count_type) > bytes_.size()) return Damaged("it is cut off");
        const double n = LoadAs(p.count_type, &bytes_[at_]);
        if (n < 0.0 || n > 1000.0) return Damaged("a face has " + std::to_string(n) + " corners");
        count = static_cast<std::size_t>(n);
        at_ += SizeOf(p.count_type);
        list->clear();
      }
      for (std::size_t i = 0; i < count; ++i) {
        if (at_ + SizeOf(p.type) > bytes_.size()) return Damaged("it is cut off");
        (p.is_list ? list : scalars)->push_back(LoadAs(p.type, &bytes_[at_]));
        at_ += SizeOf(p.type);
      }
    }
    return {};
  }

 private:
  Status ReadHeader() {
    const std::size_t end = bytes_.find("end_header\n");
    if (bytes_.rfind("ply", 0) != 0 || end == std::string::npos || end > 100000)
      return Damaged("it is not a PLY file");
    std::istringstream header(bytes_.substr(0, end));
    at_ = end + std::strlen("end_header\n");
    std::string line;
    while (std::getline(header, line)) {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "format") {
        words >> word;
        if (word != "binary_little_endian")
          return Damaged("its format is " + word + ", not binary_little_endian");
      } else if (word == "element") {
        Element e;
        words >> e.name >> e.count;
        if (!words || e.count > 200'000'000) return Damaged("its header is damaged");
        elements_.push_back(e);
      } else if (word == "property") {
        Property p;
        words >> p.type;
        if (p.type == "list") {
          p.is_list = true;
          words >> p.count_type >> p.type;
        }
        words >> p.name;
        if (!words || elements_.empty() || SizeOf(p.type) == 0 || (p.is_list && SizeOf(p.count_type) == 0)) {
          return Damaged("its header is damaged");
        }
        elements_.back().properties.push_back(p);
      }
    }
    // Rows without values would never meet the end of the file, however many the header claims.
    for (const Element& e : elements_) {
      if (e.count > 0 && e.properties.empty()) return Damaged("its header is damaged");
    }
    return {};
  }

  std::string name_, bytes_;
  std::size_t at_ = 0;
  std::vector<Element> elements_;
};

// Positions of named properties among an element's scalars.
Result<std::vector<std::size_t>> Columns(const PlyReader& reader, const Element& element,
                                         const std::vector<std::string>& names) {
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    std::size_t column = 0;
    bool found = false;
    for (const Property& p : element.properties) {
      if (p.is_list) continue;
      if (p.name == name) {
        found = true;
        break;
      }
      ++column;
    }
    if (!found) return reader.Damaged("its vertices have no property '" + name + "'");
    columns.push_back(column);
  }
  return columns;
}

}  // namespace

Status WritePointsPly(const std::filesystem::path& path, const SurfacePoints& points) {
  std::string out =
      "ply\nformat binary_little_endian 1.0\ncomment Dorsum: world frame, mm; u v in pixels of the captured "
      "image\n"
      "element vertex " +
      std::to_string(points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float "
      "ny\nproperty float nz\n"
      "property uchar laser\nproperty short order\nproperty float u\nproperty float v\nproperty float "
      "sigma\nend_header\n";
  for (const SurfacePoint& p : points) {
    AppendVector(&out, p.position);
    AppendVector(&out, p.normal);
    Append(&out, p.laser);
    Append(&out, p.order);
    Append(&out, p.u);
    Append(&out, p.v);
    Append(&out, p.sigma);
  }
  return WriteFile(path, out);
}

Status WriteMeshPly(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const bool normals = mesh.normals.size() == mesh.vertices.size() && !mesh.normals.empty();
  std::string out =
      "ply\nformat binary_little_endian 1.0\ncomment Dorsum: world frame, mm\nelement vertex " +
      std::to_string(mesh.vertices.size()) + "\nproperty float x\nproperty float y\nproperty float z\n" +
      (normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") + "element face " +
      std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    AppendVector(&out, mesh.vertices[i]);
    if (normals) AppendVector(&out, mesh.normals[i]);
  }
  for (const auto& f : mesh.faces) {
    Append(&out, std::uint8_t{3});
    for (const std::uint32_t i : f) Append(&out, static_cast<std::int32_t>(i));
  }
  return WriteFile(path, out);
}

Result<SurfacePoints> ReadPointsPly(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(PlyReader reader, PlyReader::Open(path));
  if (reader.elements().empty() || reader.elements().front().name != "vertex") {
    return reader.Damaged("it does not begin with vertices");
  }
  const Element vertex = reader.elements().front();
  DORSUM_ASSIGN_OR_RETURN(
      const auto c,
      Columns(reader, vertex, {"x", "y", "z", "nx", "ny", "nz", "laser", "order", "u", "v", "sigma"}));
  SurfacePoints points;
  std::vector<double> row, list;
  for (std::size_t i = 0; i < vertex.count; ++i) {
    DORSUM_RETURN_IF_ERROR(reader.ReadRow(vertex, &row, &list));
    SurfacePoint p;
    p.position = {row[c[0]], row[c[1]], row[c[2]]};
    p.normal = {row[c[3]], row[c[4]], row[c[5]]};
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
  for (const Element& element : reader.elements()) {
    std::vector<std::size_t> c;
    if (element.name == "vertex") {
      DORSUM_ASSIGN_OR_RETURN(c, Columns(reader, element, {"x", "y", "z"}));
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
