// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace dorsum {

struct PlyProperty {
  std::string name, type;
  bool is_list = false;
  std::string count_type;  // of a list's length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

// Walks through a binary little-endian PLY file, element by element and row by row. Every read is checked
// against the end of the file, so that a damaged or hostile file ends in an error.
class PlyReader {
 public:
  static Result<PlyReader> Open(const std::filesystem::path& path);

  const std::vector<PlyElement>& elements() const { return elements_; }

  // Values of the next row of scalars, as the properties come; those of its last list are put into `list`.
  Status ReadRow(const PlyElement& element, std::vector<double>* scalars, std::vector<double>* list);

  // Positions of named properties among an element's scalars.
  Result<std::vector<std::size_t>> Columns(const PlyElement& element,
                                           const std::vector<std::string>& names) const;

  // The sentence that refuses this file.
  Error Damaged(const std::string& what) const;

 private:
  Status ReadHeader();

  std::string name_, bytes_;
  std::size_t at_ = 0;
  std::vector<PlyElement> elements_;
};

}  // namespace dorsum
