// SPDX-License-Identifier: Apache-2.0
#include "surface/ply_reader.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "base/files.h"

namespace dorsum {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY files are read little-endian");

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

}  // namespace

Result<PlyReader> PlyReader::Open(const std::filesystem::path& path) {
  PlyReader reader;
  reader.name_ = path.string();
  DORSUM_ASSIGN_OR_RETURN(reader.bytes_, ReadFile(path));
  DORSUM_RETURN_IF_ERROR(reader.ReadHeader());
  return reader;
}

Error PlyReader::Damaged(const std::string& what) const {
  return BadInput(name_ + ": " + what + "; write the file again");
}

Status PlyReader::ReadRow(const PlyElement& element, std::vector<double>* scalars,
                          std::vector<double>* list) {
  scalars->clear();
  list->clear();
  for (const PlyProperty& p : element.properties) {
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

Status PlyReader::ReadHeader() {
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
      PlyElement e;
      words >> e.name >> e.count;
      if (!words || e.count > 200'000'000) return Damaged("its header is damaged");
      elements_.push_back(e);
    } else if (word == "property") {
      PlyProperty p;
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
  for (const PlyElement& e : elements_) {
    if (e.count > 0 && e.properties.empty()) return Damaged("its header is damaged");
  }
  return {};
}

Result<std::vector<std::size_t>> PlyReader::Columns(const PlyElement& element,
                                                    const std::vector<std::string>& names) const {
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    std::size_t column = 0;
    bool found = false;
    for (const PlyProperty& p : element.properties) {
      if (p.is_list) continue;
      if (p.name == name) {
        found = true;
        break;
      }
      ++column;
    }
    if (!found) return Damaged("its vertices have no property '" + name + "'");
    columns.push_back(column);
  }
  return columns;
}

}  // namespace dorsum
