// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "base/context.h"
#include "captures/device_description.h"
#include "device/frame_source.h"
#include "device/lights.h"

namespace dorsum {

class VirtualBench;

// A device that can be used: what people wrote about it, its camera and its lights. When it goes, the lights
// are off.
struct Device {
  std::string name;  // as it was asked for: "devices/four-lasers.toml", "virtual:7"
  DeviceDescription description;
  std::unique_ptr<FrameSource> frames;
  std::unique_ptr<Lights> lights;
  std::shared_ptr<VirtualBench> bench;  // only of a virtual device: what stands before it
};

// Opens `device.toml`, or `virtual[:SEED]`, which is the built-in four-laser device with the mounting errors
// of that seed (any text, default 1). A device.toml whose camera source is `virtual[:SEED]` is a virtual
// device of that description. A device error where camera or controller cannot be opened.
Result<Device> OpenDevice(const std::string& which, const Context& context);

// The channels that light laser k alone, and all LEDs.
ChannelSet LaserChannel(const DeviceDescription& description, int laser);
ChannelSet LedChannels(const DeviceDescription& description);

}  // namespace dorsum
