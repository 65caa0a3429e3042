// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"

namespace dorsum {

// cv::VideoCapture behind an interface, since what implements it is loaded when the first camera, stream or
// recording is opened: OpenCV's video drags in some two hundred libraries, whose start would take longer than
// a reconstruction. Members and properties are those of cv::VideoCapture, and they throw what it throws.
class VideoCapture {
 public:
  virtual ~VideoCapture() = default;
  virtual bool Open(const std::string& place, int api, const std::vector<int>& parameters) = 0;
  virtual bool Set(int property, double value) = 0;
  virtual double Get(int property) const = 0;
  // Whether a frame of a camera came within that time.
  virtual bool Wait(std::int64_t timeout_ns) = 0;
  virtual bool Grab() = 0;
  virtual bool Retrieve(cv::Mat* image) = 0;
};

// A DeviceError where the module (video_module/) is not installed beside this program.
Result<std::unique_ptr<VideoCapture>> MakeVideoCapture();

// What the module exports: no name mangling.
inline constexpr const char* kVideoModule = "dorsum_video.so";
inline constexpr const char* kMakeVideoCapture = "DorsumMakeVideoCapture";
using MakeVideoCaptureFunction = VideoCapture* (*)();

}  // namespace dorsum
