// SPDX-License-Identifier: Apache-2.0
// The module that device/video_capture.h speaks of: the only place that includes OpenCV's video.
#include <opencv2/videoio.hpp>

#include "device/video_capture.h"

namespace {

class OpenCvCapture : public dorsum::VideoCapture {
 public:
  bool Open(const std::string& place, int api, const std::vector<int>& parameters) override {
    return parameters.empty() ? capture().open(place, api) : capture().open(place, api, parameters);
  }
  bool Set(int property, double value) override { return capture().set(property, value); }
  double Get(int property) const override { return captures_[0].get(property); }
  bool Wait(std::int64_t timeout_ns) override {
    std::vector<int> ready;
    return cv::VideoCapture::waitAny(captures_, ready, timeout_ns) && !ready.empty();
  }
  bool Grab() override { return capture().grab(); }
  bool Retrieve(cv::Mat* image) override { return capture().retrieve(*image); }

 private:
  cv::VideoCapture& capture() { return captures_[0]; }
  std::vector<cv::VideoCapture> captures_{1};  // one; waitAny() wants a list
};

}  // namespace

extern "C" __attribute__((visibility("default"))) dorsum::VideoCapture* DorsumMakeVideoCapture() {
  return new OpenCvCapture;  // for a std::unique_ptr
}
