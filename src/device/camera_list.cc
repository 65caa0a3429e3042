// SPDX-License-Identifier: Apache-2.0
#include "device/camera_list.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/files.h"

namespace dorsum {
namespace {

constexpr std::size_t kMaxNameBytes = 4096;

std::optional<int> NumberOf(const std::string& file_name) {
  constexpr std::size_t kPrefix = 5;  // "video"
  if (!file_name.starts_with("video") || file_name.size() == kPrefix || file_name.size() > kPrefix + 3)
    return std::nullopt;
  const std::string digits = file_name.substr(kPrefix);
  if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return std::stoi(digits);
}

std::string NameOf(const std::filesystem::path& file) {
  const auto text = ReadFile(file, kMaxNameBytes);
  if (!text.ok()) return "";
  return text->substr(0, text->find_last_not_of(" \r\n") + 1);
}

enum class Capability { kPictures, kNone, kUnknown };

Capability AskDriver(int file) {
  v4l2_capability capability{};
  if (ioctl(file, VIDIOC_QUERYCAP, &capability) != 0) return Capability::kUnknown;
  const bool of_this_node = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0;
  const auto flags = of_this_node ? capability.device_caps : capability.capabilities;
  const bool pictures = (flags & (V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_VIDEO_CAPTURE_MPLANE)) != 0;
  return pictures ? Capability::kPictures : Capability::kNone;
}

// Fills in whether the camera can be used; false for a node that is no camera at all.
bool TryToOpen(CameraEntry& camera) {
  const int file = open(camera.device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) {
    const int reason = errno;
    camera.problem = std::string("cannot be opened: ") + std::strerror(reason);
    if (reason == EACCES || reason == EPERM) {
      camera.problem +=
          "; add yourself to the group \"video\" (sudo usermod -aG video $USER) and log in again";
    } else if (reason == EBUSY) {
      camera.problem += "; close the other program that uses it";
    } else {
      camera.problem += "; unplug it and plug it in";
    }
    return true;
  }
  const Capability capability = AskDriver(file);
  close(file);
  if (capability == Capability::kNone) return false;
  camera.usable = capability == Capability::kPictures;
  if (!camera.usable) camera.problem = "does not answer as a camera; unplug it and plug it in";
  return true;
}

}  // namespace

std::vector<CameraEntry> ListCameras() { return ListCameras("/dev", "/sys/class/video4linux"); }

std::vector<CameraEntry> ListCameras(const std::filesystem::path& dev,
                                     const std::filesystem::path& sys_class) {
  std::vector<std::pair<int, std::string>> nodes;
  std::error_code ec;
  for (std::filesystem::directory_iterator it(dev, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string name = it->path().filename().string();
    if (const auto number = NumberOf(name)) nodes.emplace_back(*number, name);
  }
  std::sort(nodes.begin(), nodes.end());
  std::vector<CameraEntry> cameras;
  for (const auto& [number, node] : nodes) {
    CameraEntry camera;
    camera.device = (dev / node).string();
    camera.name = NameOf(sys_class / node / "name");
    if (TryToOpen(camera)) cameras.push_back(std::move(camera));
  }
  return cameras;
}

}  // namespace dorsum
