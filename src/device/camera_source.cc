// SPDX-License-Identifier: Apache-2.0
#include "device/camera_source.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "device/camera_list.h"
#include "device/device_error.h"
#include "device/folder_frames.h"
#include "device/video_frames.h"

namespace dorsum {
namespace {

bool IsNumber(const std::string& text) {
  return !text.empty() && text.size() <= 3 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Which of the cameras that are there can be used, or what stands in the way.
Result<std::string> FirstCamera() {
  const std::vector<CameraEntry> cameras = ListCameras();
  for (const CameraEntry& camera : cameras) {
    if (camera.usable) return camera.device;
  }
  if (cameras.empty())
    return DeviceError("there is no camera under /dev/video; connect one, or set camera.source");
  return DeviceError("none of the cameras can be used: " + cameras.front().device + " " +
                     cameras.front().problem);
}

}  // namespace

Result<CameraSource> ParseCameraSource(const std::string& source) {
  if (source.empty()) return CameraSource{CameraKind::kFirst, ""};
  if (IsNumber(source))
    return CameraSource{CameraKind::kNumber, "/dev/video" + std::to_string(std::stoi(source))};
  if (source.starts_with("/dev/")) return CameraSource{CameraKind::kNumber, source};
  if (source == "virtual") return CameraSource{CameraKind::kVirtual, ""};
  if (source.starts_with("virtual:")) return CameraSource{CameraKind::kVirtual, source.substr(8)};
  for (const char* scheme : {"http://", "https://", "rtsp://", "tcp://", "udp://"}) {
    if (source.starts_with(scheme)) return CameraSource{CameraKind::kStream, source};
  }
  std::error_code ec;
  if (std::filesystem::is_directory(source, ec)) return CameraSource{CameraKind::kFolder, source};
  if (std::filesystem::is_regular_file(source, ec)) return CameraSource{CameraKind::kRecording, source};
  return BadInput("the camera source \"" + source +
                  "\" is none: give a number, /dev/videoN, http://…, a video file or a folder that exists, "
                  "or virtual[:SEED]");
}

Result<std::unique_ptr<FrameSource>> OpenCamera(const CameraDesign& design, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const CameraSource source, ParseCameraSource(design.source));
  switch (source.kind) {
    case CameraKind::kFirst: {
      DORSUM_ASSIGN_OR_RETURN(const std::string device, FirstCamera());
      return OpenVideoFrames(VideoKind::kCamera, device, design, {}, context);
    }
    case CameraKind::kNumber:
      return OpenVideoFrames(VideoKind::kCamera, source.place, design, {}, context);
    case CameraKind::kStream:
      return OpenVideoFrames(VideoKind::kStream, source.place, design, {}, context);
    case CameraKind::kRecording:
      return OpenVideoFrames(VideoKind::kRecording, source.place, design, {}, context);
    case CameraKind::kFolder: {
      DORSUM_ASSIGN_OR_RETURN(auto folder, FolderFrames::Open(source.place, {design.width, design.height}));
      return std::unique_ptr<FrameSource>(std::move(folder));
    }
    case CameraKind::kVirtual:
      break;
  }
  throw std::logic_error("OpenCamera() of a virtual camera");
}

}  // namespace dorsum
