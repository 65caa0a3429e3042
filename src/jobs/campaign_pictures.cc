// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_pictures.h"

#include <algorithm>
#include <map>

#include "base/files.h"
#include "captures/capture.h"
#include "captures/image_file.h"
#include "captures/image_header.h"
#include "captures/names.h"
#include "jobs/campaign_add.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPictureBytes = std::size_t{512} << 20;  // as ReadImage

// The message with the work folder, which is gone by the time that it is read, called by its source.
Error Renamed(const Error& error, const fs::path& folder, const std::string& source) {
  std::string text = error.message;
  for (std::size_t at = text.find(folder.string()); at != std::string::npos;
       at = text.find(folder.string(), at + source.size())) {
    text.replace(at, folder.string().size(), source);
  }
  return {error.code, text};
}

std::vector<int> LasersIn(const fs::path& folder) {
  std::vector<int> lasers;
  for (int laser = 0; laser < kMaxLasers; ++laser) {
    if (FindImage(folder, StripesHandName(laser))) lasers.push_back(laser);
  }
  return lasers;
}

Status CheckLasers(GatheredPictures* out, const std::string& source) {
  for (const int laser : out->lasers) {
    if (std::find(out->device.lasers.begin(), out->device.lasers.end(), laser) == out->device.lasers.end()) {
      return BadInput(source + " has a picture of laser " + std::to_string(laser) +
                      ", which the campaign's device does not have; a campaign has one device");
    }
  }
  for (const int laser : out->device.lasers) {
    if (std::find(out->lasers.begin(), out->lasers.end(), laser) == out->lasers.end()) {
      out->warnings.push_back("there is no picture of laser " + std::to_string(laser) + " in " + source +
                              "; it will give no points");
    }
  }
  return {};
}

}  // namespace

Result<GatheredPictures> GatherPictures(const fs::path& folder, const CampaignDevice& device,
                                        const std::string& source) {
  GatheredPictures out;
  out.device = device;
  out.lasers = LasersIn(folder);
  if (out.device.lasers.empty()) out.device.lasers = out.lasers;
  const Result<CaptureImages> images = LoadCapture(folder, {device.width, device.height}, out.device.lasers);
  if (!images.ok()) return Renamed(images.error(), folder, source);
  out.device.width = images->hand.cols;
  out.device.height = images->hand.rows;
  DORSUM_RETURN_IF_ERROR(CheckLasers(&out, source));

  std::map<std::string, fs::path> kept;  // from the plain name
  for (const std::string& stem : PictureStems()) {
    const auto path = FindImage(folder, stem);
    if (!path) continue;
    DORSUM_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(*path, kMaxPictureBytes));
    const Result<ImageHeader> header = ReadImageHeader(bytes);
    if (!header.ok()) return BadInput(source + ", " + stem + " " + header.error().message);
    const std::string name = stem + (header->format == "PNG" ? ".png" : ".jpg");
    kept[name] = *path;
    out.pictures.push_back({name, bytes.size(), Sha256Hex(bytes)});
  }
  std::sort(out.pictures.begin(), out.pictures.end(),
            [](const StoredPicture& a, const StoredPicture& b) { return a.name < b.name; });
  // Two steps, since bgHand.jpg may be a PNG that stands beside another bgHand.png.
  const fs::path aside = folder / ".plain";
  DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(aside));
  std::error_code ec;
  for (const auto& [name, path] : kept) {
    fs::rename(path, aside / name, ec);
    if (ec) return BadInput("cannot rename " + path.string() + ": " + ec.message());
    DORSUM_RETURN_IF_ERROR(SyncToDisk(aside / name));
  }
  DORSUM_ASSIGN_OR_RETURN(const std::vector<std::string> names, NamesIn(folder));
  for (const std::string& name : names) {
    if (name != ".plain") fs::remove_all(folder / name, ec);
  }
  for (const auto& [name, path] : kept) {
    fs::rename(aside / name, folder / name, ec);
    if (ec) return BadInput("cannot rename " + name + ": " + ec.message());
  }
  fs::remove(aside, ec);
  DORSUM_RETURN_IF_ERROR(SyncToDisk(folder));
  return out;
}

CaptureMaker ImportCapture(const fs::path& capture_dir) {
  return [capture_dir](const fs::path& folder, const Context& context) -> Status {
    std::error_code ec;
    if (!fs::is_directory(capture_dir, ec))
      return BadInput("there is no capture folder " + capture_dir.string());
    DORSUM_RETURN_IF_ERROR(MakeCampaignFolder(folder));
    for (const std::string& stem : PictureStems()) {
      DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
      const auto path = FindImage(capture_dir, stem);
      if (!path) continue;
      DORSUM_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(*path, kMaxPictureBytes));
      DORSUM_RETURN_IF_ERROR(WriteDurably(folder / path->filename(), bytes));
    }
    return {};
  };
}

}  // namespace dorsum
