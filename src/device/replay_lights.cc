// SPDX-License-Identifier: Apache-2.0
#include "device/replay_lights.h"

#include "captures/names.h"
#include "device/device.h"

namespace dorsum {
namespace {

class ReplayLights : public Lights {
 public:
  ReplayLights(DeviceDescription description, FolderFrames* frames)
      : description_(std::move(description)), frames_(frames) {}

  Status Set(const ChannelSet& on) override {
    DORSUM_RETURN_IF_ERROR(Show(on));
    on_ = on;
    return {};
  }
  Result<ChannelSet> On() override { return on_; }
  ControllerInfo info() const override {
    return {.name = "lights of " + frames_->name(), .firmware_version = "replay", .channels = kMaxChannels};
  }

 private:
  Status Show(const ChannelSet& on) {
    if (on.none()) {
      frames_->ShowBlack();
      return {};
    }
    if (on == LedChannels(description_)) return frames_->Show(kBgHandName);
    for (std::size_t k = 0; k < description_.lasers.size(); ++k) {
      const int laser = static_cast<int>(k);
      if (on == LaserChannel(description_, laser)) return frames_->Show(StripesHandName(laser));
    }
    return BadInput(frames_->name() + " has no picture under these lights together");
  }

  DeviceDescription description_;
  FolderFrames* frames_;
  ChannelSet on_;
};

}  // namespace

std::unique_ptr<Lights> MakeReplayLights(const DeviceDescription& description, FolderFrames* frames) {
  return std::make_unique<ReplayLights>(description, frames);
}

}  // namespace dorsum
