// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include <sodium.h>
#include <unistd.h>

namespace dorsum {
namespace {

namespace fs = std::filesystem;

Error CannotWrite(const fs::path& path, const std::string& why) {
  return BadInput("cannot write " + path.string() + ": " + why +
                  "; choose a folder that you may write to and that has room");
}

std::string ErrnoText() { return std::strerror(errno); }

}  // namespace

Result<std::string> ReadFile(const fs::path& path, std::size_t max_bytes) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (!fs::exists(status)) return BadInput("there is no file " + path.string());
  if (!fs::is_regular_file(status)) return BadInput(path.string() + " is not a file");
  const std::uintmax_t size = fs::file_size(path, ec);
  if (ec) return BadInput("cannot read " + path.string() + ": " + ec.message());
  if (size > max_bytes) {
    return BadInput(path.string() + " is " + std::to_string(size) + " bytes; at most " +
                    std::to_string(max_bytes) + " are expected here");
  }
  std::ifstream in(path, std::ios::binary);
  std::string content(size, '\0');
  if (!in || !in.read(content.data(), static_cast<std::streamsize>(size))) {
    return BadInput("cannot read " + path.string() + ": " + ErrnoText());
  }
  return content;
}

Status WriteFile(const fs::path& path, std::string_view content) {
  const fs::path aside = path.string() + ".part" + std::to_string(getpid());
  {
    std::ofstream out(aside, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) {
      const std::string why = ErrnoText();
      std::error_code ignored;
      fs::remove(aside, ignored);
      return CannotWrite(path, why);
    }
  }
  std::error_code ec;
  fs::rename(aside, path, ec);
  if (ec) {
    std::error_code ignored;
    fs::remove(aside, ignored);
    return CannotWrite(path, ec.message());
  }
  return {};
}

std::string Sha256Hex(std::string_view bytes) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  std::string hex(2 * hash.size() + 1, '\0');
  sodium_bin2hex(hex.data(), hex.size(), hash.data(), hash.size());
  hex.pop_back();
  return hex;
}

std::string EncodeBase64(std::string_view bytes) {
  constexpr int kVariant = sodium_base64_VARIANT_ORIGINAL;
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    bytes.size(), kVariant);
  text.pop_back();  // the terminating zero
  return text;
}

Result<std::string> DecodeBase64(std::string_view text) {
  std::string bytes(text.size() / 4 * 3 + 3, '\0');
  std::size_t length = 0;
  if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &length, nullptr, sodium_base64_VARIANT_ORIGINAL) != 0) {
    return BadInput("text is not base64");
  }
  bytes.resize(length);
  return bytes;
}

StagedFolder::StagedFolder(fs::path target) : target_(std::move(target)) {}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : target_(std::move(other.target_)), staging_(std::move(other.staging_)), made_(std::move(other.made_)) {
  other.staging_.clear();
  other.made_.clear();
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
  for (const fs::path& folder : made_) {
    if (!fs::remove(folder, ignored)) break;  // somebody else uses it by now
  }
}

Result<StagedFolder> StagedFolder::Create(const fs::path& target) {
  std::error_code ec;
  const fs::path absolute = fs::absolute(target, ec).lexically_normal();
  fs::path clean = absolute.has_filename() ? absolute : absolute.parent_path();
  if (fs::exists(clean, ec) && !fs::is_directory(clean, ec)) {
    return BadInput("cannot write to " + target.string() + ": it is a file, and a folder is needed");
  }
  StagedFolder staged(clean);
  for (fs::path up = clean.parent_path(); !fs::exists(up, ec) && up.has_relative_path();
       up = up.parent_path()) {
    staged.made_.push_back(up);
  }
  fs::create_directories(clean.parent_path(), ec);
  if (ec) return CannotWrite(target, ec.message());
  if (fs::exists(clean, ec) && access(clean.c_str(), W_OK) != 0) return CannotWrite(target, ErrnoText());
  std::string pattern = (clean.parent_path() / ("." + clean.filename().string() + ".XXXXXX")).string();
  if (mkdtemp(pattern.data()) == nullptr) return CannotWrite(target, ErrnoText());
  staged.staging_ = pattern;
  fs::permissions(pattern,
                  fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                      fs::perms::others_read | fs::perms::others_exec,
                  ec);
  return staged;
}

Status StagedFolder::Commit() {
  std::error_code ec;
  if (!fs::exists(target_, ec)) {
    fs::rename(staging_, target_, ec);
    if (ec) return CannotWrite(target_, ec.message());
    staging_.clear();
    made_.clear();
    return {};
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(staging_, ec)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), staging_));
  }
  for (const fs::path& file : files) {
    fs::create_directories((target_ / file).parent_path(), ec);
    if (!ec) fs::rename(staging_ / file, target_ / file, ec);
    if (ec) return CannotWrite(target_ / file, ec.message());
  }
  return {};
}

}  // namespace dorsum
