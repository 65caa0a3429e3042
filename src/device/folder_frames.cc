// SPDX-License-Identifier: Apache-2.0
#include "device/folder_frames.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "captures/image_file.h"
#include "device/device_error.h"

namespace dorsum {
namespace {

constexpr double kInterval_s = 1.0 / 30.0;  // of a scene that is shown

bool IsImage(const std::filesystem::path& path) {
  constexpr std::array kExtensions = {".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"};
  return std::find(kExtensions.begin(), kExtensions.end(), path.extension().string()) != kExtensions.end();
}

}  // namespace

FolderFrames::FolderFrames(std::filesystem::path folder, std::vector<std::filesystem::path> files)
    : folder_(std::move(folder)), files_(std::move(files)) {}

Result<std::unique_ptr<FolderFrames>> FolderFrames::Open(const std::filesystem::path& folder, cv::Size size) {
  std::vector<std::filesystem::path> files;
  std::error_code ec;
  for (std::filesystem::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored) && IsImage(it->path())) files.push_back(it->path());
  }
  if (ec) return BadInput("the folder " + folder.string() + " cannot be read: " + ec.message());
  if (files.empty())
    return BadInput("there is no PNG or JPEG image in " + folder.string() + " to take for a camera's");
  std::sort(files.begin(), files.end());
  std::unique_ptr<FolderFrames> frames(new FolderFrames(folder, std::move(files)));
  frames->size_ = size;
  if (size.empty()) {
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat first, ReadImage(frames->files_.front()));
    frames->size_ = first.size();
  }
  return frames;
}

Status FolderFrames::Show(const std::string& name) {
  DORSUM_ASSIGN_OR_RETURN(const std::filesystem::path path, RequireImage(folder_, name));
  DORSUM_ASSIGN_OR_RETURN(shown_, ReadImage(path, size_));
  shows_ = true;
  return {};
}

void FolderFrames::ShowBlack() {
  shown_ = cv::Mat::zeros(size_, CV_8UC3);
  shows_ = true;
}

Result<Frame> FolderFrames::Next(double timeout_s) {
  if (shows_) {
    const double wait_s = shown_at_s_ + kInterval_s - MonotonicSeconds();
    if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(std::min(wait_s, timeout_s)));
    shown_at_s_ = MonotonicSeconds();
    return Frame{shown_.clone(), shown_at_s_, given_++};
  }
  if (next_file_ == files_.size()) {
    return DeviceError(name() + " has no more images after " + files_.back().filename().string() +
                       "; record more, or begin again");
  }
  const std::filesystem::path& path = files_[next_file_++];
  const auto image = ReadImage(path, size_);
  if (!image.ok()) return DeviceError(image.error().message);
  return Frame{*image, MonotonicSeconds(), given_++};
}

}  // namespace dorsum
