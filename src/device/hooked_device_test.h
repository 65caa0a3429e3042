// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "device/device.h"

namespace dorsum {

// What happens to a device in a test: called with the number of each call, from 0.
struct DeviceHooks {
  std::function<Result<Frame>(int call, Result<Frame> frame)> frame;  // in place of a frame
  std::function<Status(int call, const ChannelSet& on)> set;          // before the lights are switched
  std::function<Result<ChannelSet>(int call, ChannelSet on)> on;      // in place of the controller's answer
  int frames = 0, sets = 0, queries = 0;                              // calls so far
};

class HookedFrames : public FrameSource {
 public:
  HookedFrames(std::unique_ptr<FrameSource> inner, std::shared_ptr<DeviceHooks> hooks)
      : inner_(std::move(inner)), hooks_(std::move(hooks)) {}
  Result<Frame> Next(double timeout_s) override {
    Result<Frame> frame = inner_->Next(timeout_s);
    const int call = hooks_->frames++;
    return hooks_->frame ? hooks_->frame(call, std::move(frame)) : frame;
  }
  Status ExposeFor(FrameLight light) override { return inner_->ExposeFor(light); }
  cv::Size size() const override { return inner_->size(); }
  std::string name() const override { return inner_->name(); }
  std::vector<std::string> warnings() const override { return inner_->warnings(); }
  bool stamps_exposure() const override { return inner_->stamps_exposure(); }
  bool never_repeats() const override { return inner_->never_repeats(); }

 private:
  std::unique_ptr<FrameSource> inner_;
  std::shared_ptr<DeviceHooks> hooks_;
};

class HookedLights : public Lights {
 public:
  HookedLights(std::unique_ptr<Lights> inner, std::shared_ptr<DeviceHooks> hooks)
      : inner_(std::move(inner)), hooks_(std::move(hooks)) {}
  Status Set(const ChannelSet& on) override {
    const int call = hooks_->sets++;
    if (hooks_->set) {
      if (Status status = hooks_->set(call, on); !status.ok()) {
        static_cast<void>(inner_->Set({}));  // a controller that lost its host switches off
        return status;
      }
    }
    return inner_->Set(on);
  }
  Result<ChannelSet> On() override {
    DORSUM_ASSIGN_OR_RETURN(const ChannelSet on, inner_->On());
    const int call = hooks_->queries++;
    return hooks_->on ? hooks_->on(call, on) : Result<ChannelSet>(on);
  }
  ControllerInfo info() const override { return inner_->info(); }

 private:
  std::unique_ptr<Lights> inner_;
  std::shared_ptr<DeviceHooks> hooks_;
};

// Puts hooks between a device and whoever uses it.
inline std::shared_ptr<DeviceHooks> Hook(Device& device) {
  auto hooks = std::make_shared<DeviceHooks>();
  device.frames = std::make_unique<HookedFrames>(std::move(device.frames), hooks);
  device.lights = std::make_unique<HookedLights>(std::move(device.lights), hooks);
  return hooks;
}

}  // namespace dorsum
