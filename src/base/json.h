// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.h"

namespace dorsum {

// Order of keys as written, so that files are stable and read well.
using Json = nlohmann::ordered_json;

Result<Json> ReadJson(const std::filesystem::path& path);
Status WriteJson(const std::filesystem::path& path, const Json& json);

// Reads typed values of one JSON object and keeps the first error, which names the file and the key. After
// an error all reads give zero values, so that a reader is a flat list of reads and one check at its end.
class JsonReader {
 public:
  JsonReader(const Json& object, std::string where);  // where: the file's name, for messages

  double Number(const std::string& key, double min = std::numeric_limits<double>::lowest(),
                double max = std::numeric_limits<double>::max());
  int Integer(const std::string& key, int min, int max);
  std::string Text(const std::string& key);
  bool Bool(const std::string& key);
  // Finite numbers; `count` of them unless it is negative.
  std::vector<double> Numbers(const std::string& key, int count = -1,
                              double min = std::numeric_limits<double>::lowest(),
                              double max = std::numeric_limits<double>::max());
  const Json& Object(const std::string& key);
  const Json& Array(const std::string& key, int max_count);
  bool Has(const std::string& key) const;
  // Checks `schema` and `version` of a machine-written file.
  void Schema(const std::string& schema, int version);

  void Fail(const std::string& key, const std::string& what);
  Status status() const;

 private:
  const Json* Find(const std::string& key);
  const Json* object_;
  std::string where_;
  bool failed_ = false;
  std::string message_;
};

}  // namespace dorsum
