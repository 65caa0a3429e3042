// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_export_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>

#include "base/files.h"
#include "base/json.h"
#include "captures/image_file.h"
#include "captures/picture_metadata.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The folders after what lies in them, whose writing would change them again.
Status MakeTimesNeutral(const fs::path& root) {
  constexpr std::time_t kDay = 946684800;
  std::vector<fs::path> paths = {root};
  std::error_code ec;
  for (fs::recursive_directory_iterator it(root, ec), end; !ec && it != end; it.increment(ec)) {
    paths.push_back(it->path());
  }
  if (ec) return BadInput("cannot read " + root.string() + ": " + ec.message());
  std::sort(paths.rbegin(), paths.rend());
  const std::array<timespec, 2> times = {timespec{kDay, 0}, timespec{kDay, 0}};
  for (const fs::path& path : paths) {
    if (utimensat(AT_FDCWD, path.c_str(), times.data(), 0) != 0)
      return BadInput("cannot set the time of " + path.string() + ": " + std::strerror(errno));
  }
  return {};
}

}  // namespace

Result<std::string> PlainPicture(const std::string& bytes, const std::string& where) {
  Result<std::string> plain = WithoutMetadata(bytes);
  if (!plain.ok()) return BadInput(where + " " + plain.error().message + "; restore it from a copy");
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat before, DecodeImage(bytes, where));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat after, DecodeImage(*plain, where));
  const auto size = before.total() * before.elemSize();
  if (before.size() != after.size() || std::memcmp(before.data, after.data, size) != 0) {
    return BadInput(where + " shows something else without its metadata; save it anew as PNG");
  }
  return plain;
}

Result<std::string> PlainCalibration(const fs::path& path) {
  DORSUM_ASSIGN_OR_RETURN(Json json, ReadJson(path));
  const bool known = json.is_object() && json.contains("background_image_base64") &&
                     json["background_image_base64"].is_string();
  if (!known) return BadInput(path.string() + " is no calibration; restore it from a copy");
  json["made_from"] = Json::array();
  json["warnings"] = Json::array();
  DORSUM_ASSIGN_OR_RETURN(const std::string background,
                          DecodeBase64(json["background_image_base64"].get<std::string>()));
  DORSUM_ASSIGN_OR_RETURN(const std::string plain, PlainPicture(background, path.string()));
  json["background_image_base64"] = EncodeBase64(plain);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Status ExportWriter::Write(const std::string& name, const std::string& bytes) {
  std::error_code ec;
  fs::create_directories((root_ / name).parent_path(), ec);
  if (ec) return BadInput("cannot write " + (root_ / name).string() + ": " + ec.message());
  sums_.emplace(name, Sha256Hex(bytes));
  return WriteFile(root_ / name, bytes);
}

Status ExportWriter::Finish() {
  std::string text;
  for (const auto& [name, sum] : sums_) text += sum + "  " + name + "\n";
  DORSUM_RETURN_IF_ERROR(WriteFile(root_ / "SHA256SUMS", text));
  return MakeTimesNeutral(root_);
}

}  // namespace dorsum
