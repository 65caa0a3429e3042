// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "base/context.h"
#include "base/result.h"
#include "captures/device_description.h"
#include "device/frame_source.h"

namespace dorsum {

enum class CameraKind {
  kFirst,      // whatever camera comes first
  kNumber,     // /dev/videoN
  kStream,     // a network stream: http://…, rtsp://…
  kRecording,  // a video file
  kFolder,     // a folder of images
  kVirtual,    // a simulated device: virtual[:SEED]
};

// What `source` of CameraDesign stands for.
struct CameraSource {
  CameraKind kind = CameraKind::kFirst;
  std::string place;  // device file, address, file or folder; the seed of a virtual one; empty for kFirst
};

// An error of input for a text that is none of these, and for a file that does not exist.
Result<CameraSource> ParseCameraSource(const std::string& source);

// Opens the camera that a description asks for, at its resolution, and waits for its first picture. A device
// error when it cannot be opened, gives no picture or one of another size; an error of input for a source
// that cannot be understood. A virtual camera is not opened here, since it needs its device:
// std::logic_error.
Result<std::unique_ptr<FrameSource>> OpenCamera(const CameraDesign& design, const Context& context);

}  // namespace dorsum
