// SPDX-License-Identifier: Apache-2.0
#include "device/device.h"

#include <optional>
#include <utility>

#include "device/real_device.h"
#include "device/virtual_bench.h"
#include "device/virtual_frames.h"

namespace dorsum {
namespace {

// The seed in "virtual[:SEED]"; none for anything else.
std::optional<std::string> VirtualSeed(const std::string& text) {
  const std::string word = "virtual";
  if (text == word) return "1";
  if (text.rfind(word + ":", 0) == 0 && text.size() > word.size() + 1) return text.substr(word.size() + 1);
  return std::nullopt;
}

Device MakeVirtual(std::string name, DeviceDescription description, const std::string& seed, int threads) {
  Device device;
  device.name = std::move(name);
  device.bench = std::make_shared<VirtualBench>(description, seed, threads);
  device.frames = MakeVirtualFrames(device.bench);
  device.lights = MakeVirtualLights(device.bench);
  device.description = std::move(description);
  return device;
}

}  // namespace

Result<Device> OpenDevice(const std::string& which, const Context& context) {
  if (const auto seed = VirtualSeed(which)) {
    return MakeVirtual(which, DefaultDevice(), *seed, context.threads);
  }
  DORSUM_ASSIGN_OR_RETURN(DeviceDescription description, ReadDeviceDescription(which));
  if (const auto seed = VirtualSeed(description.camera.source)) {
    return MakeVirtual(which, std::move(description), *seed, context.threads);
  }
  return OpenRealDevice(which, std::move(description), context);
}

ChannelSet LaserChannel(const DeviceDescription& description, int laser) {
  const int channel = description.lasers.at(static_cast<std::size_t>(laser)).channel;
  ChannelSet on;
  on.set(static_cast<std::size_t>(channel < 0 ? laser : channel));
  return on;
}

ChannelSet LedChannels(const DeviceDescription& description) {
  ChannelSet on;
  for (const LedDesign& led : description.leds) on.set(static_cast<std::size_t>(led.channel));
  return on;
}

}  // namespace dorsum
