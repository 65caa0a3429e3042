// SPDX-License-Identifier: Apache-2.0
#include "captures/capture.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/files.h"
#include "base/parallel.h"
#include "captures/image_file.h"
#include "captures/image_header.h"
#include "captures/names.h"

namespace dorsum {
namespace {

// One image of a capture.
struct Picture {
  std::filesystem::path path;
  std::optional<cv::Size> size;  // that it must have
  bool shows_something = true;   // that it must
  Channels channels = Channels::kBgr;
  cv::Mat image;
  Status status;
};

Status Read(Picture* picture) {
  DORSUM_ASSIGN_OR_RETURN(picture->image, ReadImage(picture->path, picture->size, picture->channels));
  if (!picture->shows_something) return {};
  return CheckExposure(picture->image, picture->path.string());
}

// As the file's beginning says; empty where that is no image.
cv::Size SizeOf(const std::filesystem::path& path) {
  const Result<std::string> bytes = ReadFile(path, std::size_t{512} << 20);
  if (!bytes.ok()) return {};
  const Result<ImageHeader> header = ReadImageHeader(*bytes);
  return header.ok() ? cv::Size(header->width, header->height) : cv::Size();
}

}  // namespace

std::string MissingStripes(const std::filesystem::path& dir, int laser) {
  return "the image " + StripesHandName(laser) + " is missing in " + dir.string() + "; laser " +
         std::to_string(laser) + " gives no points";
}

Result<CaptureImages> LoadCapture(const std::filesystem::path& dir, cv::Size expected,
                                  const std::vector<int>& lasers, const Context& context, Channels stripes) {
  std::error_code ec;
  if (!std::filesystem::is_directory(dir, ec)) return BadInput("there is no capture folder " + dir.string());
  CaptureImages capture;
  DORSUM_ASSIGN_OR_RETURN(const auto hand_path, RequireImage(dir, kBgHandName));
  std::vector<Picture> pictures(1);
  pictures[0].path = hand_path;
  if (!expected.empty()) pictures[0].size = expected;
  const cv::Size size = SizeOf(hand_path);
  std::vector<int> seen;
  for (const int laser : lasers) {
    const std::string name = StripesHandName(laser);
    capture.stripes.resize(
        std::max<std::size_t>(capture.stripes.size(), static_cast<std::size_t>(laser) + 1));
    if (const auto path = FindImage(dir, name)) {
      pictures.push_back({.path = *path, .size = size, .channels = stripes, .image = {}, .status = {}});
      seen.push_back(laser);
      continue;
    }
    capture.warnings.push_back(MissingStripes(dir, laser));
  }
  const auto after = FindImage(dir, kBgHandAfterName);
  if (after)
    pictures.push_back({.path = *after, .size = size, .shows_something = false, .image = {}, .status = {}});

  ParallelFor(context, 0, static_cast<std::int64_t>(pictures.size()), [&](std::int64_t i) {
    Picture& picture = pictures[static_cast<std::size_t>(i)];
    picture.status = Read(&picture);
  });
  for (std::size_t i = 0; i <= seen.size(); ++i) DORSUM_RETURN_IF_ERROR(pictures[i].status);
  if (seen.empty()) return BadInput("there is no image stripesHand0, stripesHand1, … in " + dir.string());
  DORSUM_RETURN_IF_ERROR(pictures.back().status);
  capture.hand = std::move(pictures[0].image);
  for (std::size_t i = 0; i < seen.size(); ++i)
    capture.stripes[static_cast<std::size_t>(seen[i])] = std::move(pictures[i + 1].image);
  if (after) capture.hand_after = std::move(pictures.back().image);
  return capture;
}

}  // namespace dorsum
