// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "captures/device_description.h"
#include "device/frame_source.h"

namespace dorsum {

enum class VideoKind {
  kCamera,     // a device file, through Video4Linux
  kStream,     // an address, through FFmpeg
  kRecording,  // a video file, through FFmpeg
};

struct VideoLimits {
  double open_s = 5.0;     // for opening and the first picture, 0.1 to 60
  double silence_s = 2.0;  // without a picture a camera or stream counts as gone, 0.1 to 60
};

// cv::VideoCapture with its troubles turned into words. Blocking: for a thread of its own, which alone uses
// it.
class VideoInput {
 public:
  virtual ~VideoInput() = default;

  static Result<std::unique_ptr<VideoInput>> Open(VideoKind kind, const std::string& place,
                                                  const CameraDesign& design, const VideoLimits& limits);

  struct Picture {
    cv::Mat image;        // CV_8UC3; empty where the picture was damaged
    double time_s = 0.0;  // MonotonicSeconds()
  };
  // The next picture; none when a wait of 0.1 s or so brought none; an error when there will be none.
  virtual Result<std::optional<Picture>> Read() = 0;
  // To be called once pictures come, and for the exposure of later ones; both give the sentences of
  // camera_controls.h.
  virtual std::vector<std::string> Begin() = 0;
  virtual std::vector<std::string> Expose(FrameLight light) = 0;
  // Whether Begin() and Expose() do anything, so that pictures under way are not as those to come.
  virtual bool CanBeSet() const = 0;
  virtual const std::vector<std::string>& warnings() const = 0;  // of opening
};

// For people: "the camera /dev/video0", "the stream http://…", "the recording hand.avi".
std::string VideoName(VideoKind kind, const std::string& place);

}  // namespace dorsum
