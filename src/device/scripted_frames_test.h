// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "device/device_error.h"
#include "device/frame_source.h"

namespace dorsum {

// A camera made of a function: a frame every `interval_s`, in the clock of its stamps only, so that tests
// need not wait. The painter is told when the frame was exposed, which is `latency_s` before its stamp.
class ScriptedFrames : public FrameSource {
 public:
  using Painter = std::function<cv::Mat(double exposed_at_s, int number)>;

  ScriptedFrames(cv::Size size, Painter painter) : size_(size), painter_(std::move(painter)) {}

  double interval_s = 1.0 / 30.0;
  double latency_s = 0.0;             // between exposure and stamp: frames waiting in a queue
  double now_s = MonotonicSeconds();  // of the newest frame
  std::optional<int> last_frame;      // then the camera is gone
  bool exact = false, noisy = false;  // stamps_exposure(), never_repeats()
  std::vector<FrameLight> exposures;  // asked for
  int given = 0;

  Result<Frame> Next(double /*timeout_s*/) override {
    if (last_frame && given > *last_frame) return DeviceError("the scripted camera is gone; plug it in");
    now_s += interval_s;
    Frame frame{painter_(now_s - latency_s, given), now_s, given};
    ++given;
    return frame;
  }
  Status ExposeFor(FrameLight light) override {
    exposures.push_back(light);
    return {};
  }
  cv::Size size() const override { return size_; }
  std::string name() const override { return "the scripted camera"; }
  std::vector<std::string> warnings() const override { return {}; }
  bool stamps_exposure() const override { return exact; }
  bool never_repeats() const override { return noisy; }

 private:
  cv::Size size_;
  Painter painter_;
};

}  // namespace dorsum
