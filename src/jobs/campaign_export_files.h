// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "base/result.h"

namespace dorsum {

// What of a campaign's files others get, and how it is written.

// The picture without metadata, if its pixels are still the same; `where` names it in messages.
Result<std::string> PlainPicture(const std::string& bytes, const std::string& where);

// A calibration without the files that it was made from and what was said about them, its picture plain.
Result<std::string> PlainCalibration(const std::filesystem::path& path);

// Writes the files of an export and remembers their checksums.
class ExportWriter {
 public:
  explicit ExportWriter(std::filesystem::path root) : root_(std::move(root)) {}
  Status Write(const std::string& name, const std::string& bytes);
  // SHA256SUMS, and 1 January 2000 as the time of every file and folder.
  Status Finish();

 private:
  std::filesystem::path root_;
  std::set<std::pair<std::string, std::string>> sums_;  // name and SHA-256
};

}  // namespace dorsum
