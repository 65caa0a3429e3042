// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace dorsum {

// The whole content of a regular file of at most max_bytes.
Result<std::string> ReadFile(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{1} << 30);

// Writes aside and renames, so that the path holds either the old content or all of the new.
Status WriteFile(const std::filesystem::path& path, std::string_view content);

// Hex SHA-256 of bytes (libsodium), to name what a result was made from.
std::string Sha256Hex(std::string_view bytes);

// Standard base64 (RFC 4648) of bytes, and back; an error for text that is not base64.
std::string EncodeBase64(std::string_view bytes);
Result<std::string> DecodeBase64(std::string_view text);

// A folder that appears whole or not at all: files are written into a sibling staging folder and moved to
// the target by Commit(). Files of the target that this run did not write stay as they are. The staging
// folder, and folders above it that were made for it, are removed when the object goes without Commit.
class StagedFolder {
 public:
  static Result<StagedFolder> Create(const std::filesystem::path& target);
  StagedFolder(StagedFolder&& other) noexcept;
  StagedFolder& operator=(StagedFolder&&) = delete;
  ~StagedFolder();

  const std::filesystem::path& path() const { return staging_; }  // write here
  Status Commit();

 private:
  explicit StagedFolder(std::filesystem::path target);
  std::filesystem::path target_;
  std::filesystem::path staging_;
  std::vector<std::filesystem::path> made_;  // folders above the target that Create made, the deepest first
};

}  // namespace dorsum
