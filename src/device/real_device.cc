// SPDX-License-Identifier: Apache-2.0
#include "device/real_device.h"

#include <utility>

#include "device/camera_source.h"
#include "device/folder_frames.h"
#include "device/replay_lights.h"
#include "device/serial_lights.h"

namespace dorsum {
namespace {

ChannelSet AllChannels(const DeviceDescription& description) {
  ChannelSet all = LedChannels(description);
  for (std::size_t k = 0; k < description.lasers.size(); ++k) {
    all |= LaserChannel(description, static_cast<int>(k));
  }
  return all;
}

Status OpenReplay(const std::string& folder, Device* device) {
  const CameraDesign& camera = device->description.camera;
  DORSUM_ASSIGN_OR_RETURN(auto frames, FolderFrames::Open(folder, {camera.width, camera.height}));
  device->lights = MakeReplayLights(device->description, frames.get());
  device->frames = std::move(frames);
  return {};
}

}  // namespace

Result<Device> OpenRealDevice(const std::string& name, DeviceDescription description,
                              const Context& context) {
  Device device;
  device.name = name;
  device.description = std::move(description);
  const DeviceDescription& d = device.description;
  DORSUM_ASSIGN_OR_RETURN(const CameraSource source, ParseCameraSource(d.camera.source));
  if (source.kind == CameraKind::kFolder) {
    DORSUM_RETURN_IF_ERROR(OpenReplay(source.place, &device));
    return device;
  }
  SerialLightsOptions lights;
  lights.port = d.controller_port;
  lights.baud = d.controller_baud;
  lights.needed = AllChannels(d);
  DORSUM_ASSIGN_OR_RETURN(device.lights, OpenSerialLights(lights, context));
  DORSUM_ASSIGN_OR_RETURN(device.frames, OpenCamera(d.camera, context));
  return device;
}

}  // namespace dorsum
