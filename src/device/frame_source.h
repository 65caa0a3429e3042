// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"

namespace dorsum {

// Seconds on the clock that only runs forward, from any beginning.
double MonotonicSeconds();

struct Frame {
  cv::Mat image;            // CV_8UC3, BGR, its own memory
  double time_s = 0.0;      // when it was exposed, as exactly as the source knows; MonotonicSeconds()
  std::int64_t number = 0;  // counts the source's frames from 0; gaps where some were lost
};

// What the frames to come will show: it decides the exposure.
enum class FrameLight { kLaser, kLeds };

// Where frames come from: a camera, a stream, a file, a folder, the virtual device. Used by one thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // The next frame, none twice and none older than one already given. A device error in one sentence when
  // none comes within `timeout_s`, when the camera is gone, or when the frame has another size than size().
  virtual Result<Frame> Next(double timeout_s) = 0;
  // The exposure of all frames after those already under way.
  virtual Status ExposeFor(FrameLight light) = 0;

  virtual cv::Size size() const = 0;
  virtual std::string name() const = 0;                   // for people: "camera /dev/video0"
  virtual std::vector<std::string> warnings() const = 0;  // settings that could not be made, a sentence each

  // Whether time_s is known to be the exposure's own, within some milliseconds. A camera's is not: a frame
  // may have waited in queues that nobody sees before it was stamped.
  virtual bool stamps_exposure() const { return false; }
  // Whether two frames are never equal byte for byte, as a sensor's noise has it: then a source that repeats
  // itself has frozen.
  virtual bool never_repeats() const { return false; }
};

}  // namespace dorsum
