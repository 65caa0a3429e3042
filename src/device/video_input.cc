// SPDX-License-Identifier: Apache-2.0
#include "device/video_input.h"

#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <opencv2/videoio.hpp>
#include <unistd.h>

#include "captures/image_file.h"
#include "device/camera_controls.h"
#include "device/device_error.h"
#include "device/video_capture.h"

namespace dorsum {
namespace {

constexpr std::int64_t kPoll_ns = 100'000'000;
constexpr int kMaxFailures = 5;
constexpr auto kAfterFailure = std::chrono::milliseconds(20);
constexpr double kOldest_s = 5.0;  // a driver's stamp further back is of another clock

std::string Seconds(double s) {
  std::ostringstream out;
  out.precision(3);
  out << s << " s";
  return out.str();
}

class OpenCvProperties : public CameraProperties {
 public:
  explicit OpenCvProperties(VideoCapture& capture) : capture_(capture) {}
  bool Set(int property, double value) override { return capture_.Set(property, value); }
  double Get(int property) const override { return capture_.Get(property); }

 private:
  VideoCapture& capture_;
};

// What VideoCapture gives undecoded is decoded here: a damaged picture is then known for one, where FFmpeg
// would paint over the gap and libjpeg warn on the standard error.
cv::Mat Decoded(const cv::Mat& raw) {
  const auto* bytes = reinterpret_cast<const char*>(raw.data);
  std::size_t size = raw.total() * raw.elemSize();
  while (size > 2 && bytes[size - 1] == '\0') --size;  // some cameras fill up a block
  const auto image = DecodeImage(std::string(bytes, size), "picture");
  return image.ok() ? *image : cv::Mat();
}

class OpenCvInput : public VideoInput {
 public:
  OpenCvInput(std::unique_ptr<VideoCapture> capture, VideoKind kind, std::string name, CameraDesign design,
              const VideoLimits& limits)
      : kind_(kind),
        name_(std::move(name)),
        design_(std::move(design)),
        limits_(limits),
        capture_(std::move(capture)),
        properties_(*capture_) {}

  Status OpenCamera(const std::string& device) {
    // VideoCapture does not say why it cannot open, so that is found out first.
    const int file = open(device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) {
      const int reason = errno;
      const char* cure = reason == EACCES  ? "add yourself to the group \"video\" and log in again"
                         : reason == EBUSY ? "close the other program that uses it"
                                           : "check that it is connected";
      return DeviceError(name_ + " cannot be opened: " + std::strerror(reason) + "; " + cure);
    }
    close(file);
    if (!capture_->Open(device, cv::CAP_V4L2, {})) {
      return DeviceError(name_ +
                         " cannot be opened as a camera; close other programs that use it, or choose "
                         "another one with camera.source");
    }
    warnings_ = SetFormat(design_, properties_);
    if (IsJpeg()) raw_ = capture_->Set(cv::CAP_PROP_CONVERT_RGB, 0.0);
    return {};
  }

  Status OpenWithFfmpeg(const std::string& place) {
    const double started_s = MonotonicSeconds();
    const bool opened =
        capture_->Open(place, cv::CAP_FFMPEG,
                       {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, static_cast<int>(limits_.open_s * 1000.0),
                        cv::CAP_PROP_READ_TIMEOUT_MSEC, static_cast<int>(limits_.silence_s * 1000.0)});
    if (!opened) {
      if (kind_ == VideoKind::kRecording)
        return DeviceError(name_ + " is no video that can be read, or it is damaged; record it again");
      const bool late = MonotonicSeconds() - started_s > 0.9 * limits_.open_s;
      return DeviceError(name_ +
                         (late ? " did not answer within " + Seconds(limits_.open_s) : " cannot be opened") +
                         "; check the address, and that the camera is on and in the network");
    }
    if (IsJpeg()) raw_ = capture_->Set(cv::CAP_PROP_FORMAT, -1.0);
    frames_promised_ = capture_->Get(cv::CAP_PROP_FRAME_COUNT);
    return {};
  }

  Result<std::optional<Picture>> Read() override {
    try {
      if (kind_ == VideoKind::kCamera && !Wait()) {
        if (MonotonicSeconds() - last_s_ < limits_.silence_s) return std::optional<Picture>();
        return Silent();
      }
      const double asked_s = MonotonicSeconds();
      if (!capture_->Grab()) {
        if (kind_ == VideoKind::kCamera && Forgive()) return std::optional<Picture>();
        return WhyNoMore(MonotonicSeconds() - asked_s);
      }
      Picture picture;
      picture.time_s = Stamp();
      cv::Mat image;
      if (capture_->Retrieve(&image)) picture.image = raw_ ? Decoded(image) : image.clone();
      if (picture.image.type() != CV_8UC3) picture.image.release();
      last_s_ = MonotonicSeconds();
      ++frames_read_;
      failures_ = 0;
      return std::optional(std::move(picture));
    } catch (const cv::Exception&) {
      if (kind_ == VideoKind::kCamera && Forgive()) return std::optional<Picture>();
      return DeviceError(name_ + " is gone; check its cable and plug it in again");
    }
  }

  std::vector<std::string> Begin() override {
    return kind_ == VideoKind::kCamera ? SetControls(design_, properties_) : std::vector<std::string>();
  }
  std::vector<std::string> Expose(FrameLight light) override {
    return kind_ == VideoKind::kCamera ? SetExposure(design_, light, properties_)
                                       : std::vector<std::string>();
  }
  bool CanBeSet() const override { return kind_ == VideoKind::kCamera; }
  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  bool IsJpeg() {
    const int code = static_cast<int>(capture_->Get(cv::CAP_PROP_FOURCC));
    for (const char* name : {"MJPG", "JPEG", "mjpg", "mjpe", "jpeg"}) {
      if (code == FourCc(name)) return true;
    }
    return false;
  }

  // grab() of a camera would wait for ten seconds, deaf to everything; so it is asked when there is a frame.
  bool Wait() { return capture_->Wait(kPoll_ns); }

  // A single transfer may fail; a camera that was unplugged fails at each.
  bool Forgive() {
    if (++failures_ >= kMaxFailures) return false;
    std::this_thread::sleep_for(kAfterFailure);
    return true;
  }

  // Video4Linux stamps frames by the clock of MonotonicSeconds() when it works as it should.
  double Stamp() {
    const double now_s = MonotonicSeconds();
    if (kind_ != VideoKind::kCamera) return now_s;
    const double driver_s = capture_->Get(cv::CAP_PROP_POS_MSEC) / 1000.0;
    return driver_s > now_s - kOldest_s && driver_s <= now_s ? driver_s : now_s;
  }

  Error Silent() const {
    return DeviceError(name_ + " stopped sending pictures: none came for " + Seconds(limits_.silence_s) +
                       "; check its cable and plug it in again");
  }

  Error WhyNoMore(double waited_s) const {
    if (kind_ == VideoKind::kRecording) {
      const std::string frames = std::to_string(frames_read_) + (frames_read_ == 1 ? " frame" : " frames");
      if (frames_promised_ > frames_read_ && frames_promised_ < 1e9) {
        return DeviceError(name_ + " is cut off after " + frames + " of " +
                           std::to_string(static_cast<long>(frames_promised_)) + "; copy or record it again");
      }
      return DeviceError(name_ + " has ended after " + frames + "; record more, or begin again");
    }
    if (waited_s > 0.9 * limits_.silence_s) return Silent();
    return DeviceError(name_ + (kind_ == VideoKind::kStream ? " was closed by the other side" : " is gone") +
                       "; check that the camera is on and connected, and start again");
  }

  const VideoKind kind_;
  const std::string name_;
  const CameraDesign design_;
  const VideoLimits limits_;
  const std::unique_ptr<VideoCapture> capture_;
  OpenCvProperties properties_;
  std::vector<std::string> warnings_;
  bool raw_ = false;
  double last_s_ = MonotonicSeconds();
  double frames_promised_ = 0.0;
  long frames_read_ = 0;
  int failures_ = 0;  // in a row
};

}  // namespace

Result<std::unique_ptr<VideoInput>> VideoInput::Open(VideoKind kind, const std::string& place,
                                                     const CameraDesign& design, const VideoLimits& limits) {
  DORSUM_ASSIGN_OR_RETURN(std::unique_ptr<VideoCapture> capture, MakeVideoCapture());
  auto input =
      std::make_unique<OpenCvInput>(std::move(capture), kind, VideoName(kind, place), design, limits);
  try {
    DORSUM_RETURN_IF_ERROR(kind == VideoKind::kCamera ? input->OpenCamera(place)
                                                      : input->OpenWithFfmpeg(place));
  } catch (const cv::Exception&) {
    return DeviceError(VideoName(kind, place) + " cannot be opened; check that it is connected");
  }
  return std::unique_ptr<VideoInput>(std::move(input));
}

std::string VideoName(VideoKind kind, const std::string& place) {
  const char* kinds[] = {"the camera ", "the stream ", "the recording "};
  return kinds[static_cast<int>(kind)] + place;
}

}  // namespace dorsum
