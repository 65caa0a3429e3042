// SPDX-License-Identifier: Apache-2.0
#include "device/virtual_frames.h"

#include <utility>

namespace dorsum {
namespace {

class VirtualFrames : public FrameSource {
 public:
  explicit VirtualFrames(std::shared_ptr<VirtualBench> bench) : bench_(std::move(bench)) {}

  Result<Frame> Next(double /*timeout_s*/) override {
    Frame frame;
    frame.time_s = MonotonicSeconds();
    DORSUM_ASSIGN_OR_RETURN(frame.image, bench_->Expose());
    frame.number = number_++;
    return frame;
  }
  Status ExposeFor(FrameLight /*light*/) override { return {}; }  // the bench exposes as the light is

  cv::Size size() const override {
    const CameraDesign& camera = bench_->device().description.camera;
    return {camera.width, camera.height};
  }
  std::string name() const override { return "virtual camera"; }
  std::vector<std::string> warnings() const override { return {}; }
  bool stamps_exposure() const override { return true; }
  bool never_repeats() const override { return true; }

 private:
  std::shared_ptr<VirtualBench> bench_;
  std::int64_t number_ = 0;
};

class VirtualLights : public Lights {
 public:
  explicit VirtualLights(std::shared_ptr<VirtualBench> bench) : bench_(std::move(bench)) {}
  ~VirtualLights() override { bench_->Switch({}); }
  VirtualLights(const VirtualLights&) = delete;
  VirtualLights& operator=(const VirtualLights&) = delete;

  Status Set(const ChannelSet& on) override {
    bench_->Switch(on);
    return {};
  }
  Result<ChannelSet> On() override { return bench_->On(); }
  ControllerInfo info() const override {
    return {.name = "virtual light controller", .firmware_version = "virtual", .channels = kMaxChannels};
  }

 private:
  std::shared_ptr<VirtualBench> bench_;
};

}  // namespace

std::unique_ptr<FrameSource> MakeVirtualFrames(std::shared_ptr<VirtualBench> bench) {
  return std::make_unique<VirtualFrames>(std::move(bench));
}

std::unique_ptr<Lights> MakeVirtualLights(std::shared_ptr<VirtualBench> bench) {
  return std::make_unique<VirtualLights>(std::move(bench));
}

}  // namespace dorsum
