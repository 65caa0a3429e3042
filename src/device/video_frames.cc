// SPDX-License-Identifier: Apache-2.0
#include "device/video_frames.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "device/device_error.h"

namespace dorsum {
namespace {

constexpr int kUnderWay = 4;      // pictures until a camera's new exposure shows: two or three with webcams
constexpr std::size_t kKept = 4;  // frames
constexpr double kPatience_s = 0.5;  // beyond the limits, before a thread is abandoned
constexpr auto kCancelCheck = std::chrono::milliseconds(50);

std::chrono::duration<double> Duration(double s) { return std::chrono::duration<double>(std::max(s, 0.0)); }

std::string SizeText(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

std::string Seconds(double s) {
  std::ostringstream out;
  out.precision(3);
  out << s << " s";
  return out.str();
}

// What the reading thread and the frames' user share. Each holds it, so that either may go first.
struct Exchange {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Frame> frames;
  std::vector<std::string> warnings;
  std::optional<Error> error;        // there will be no further frame
  std::optional<FrameLight> wanted;  // an exposure to be set
  bool opened = false;               // the first frame has come
  bool stop = false;                 // the user wants no more
  bool ended = false;                // the thread is about to return
};

void AddWarnings(std::vector<std::string>& all, const std::vector<std::string>& more) {
  for (const std::string& warning : more) {
    if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
  }
}

// The reading thread. Holds copies and its share of the exchange, nothing else.
class Reader {
 public:
  Reader(std::shared_ptr<Exchange> exchange, VideoKind kind, std::string name, VideoOpener opener,
         cv::Size size, VideoLimits limits)
      : exchange_(std::move(exchange)),
        kind_(kind),
        name_(std::move(name)),
        opener_(std::move(opener)),
        size_(size),
        limits_(limits) {}

  void Run() {
    std::optional<Error> error;
    try {
      error = ReadAll();
    } catch (const std::exception& e) {
      error = DeviceError(name_ + " failed: " + e.what() + "; start again");
    }
    const std::lock_guard lock(exchange_->mutex);
    exchange_->error = error;
    exchange_->ended = true;
    exchange_->changed.notify_all();
  }

 private:
  // Returns at an error, or with none when asked to stop. The input is closed then.
  std::optional<Error> ReadAll() {
    auto opened = opener_();
    if (!opened.ok()) return opened.error();
    const std::unique_ptr<VideoInput> input = std::move(opened).value();
    Warn(input->warnings());
    double whole_s = MonotonicSeconds();  // when the newest whole picture came
    bool begun = false;
    for (std::int64_t number = 0; Continue(*input); ++number) {
      Result<std::optional<VideoInput::Picture>> read = input->Read();
      if (!read.ok()) return read.error();
      if (!read->has_value()) {
        --number;
        continue;
      }
      VideoInput::Picture picture = std::move(**read);
      if (picture.image.empty()) {
        if (kind_ == VideoKind::kRecording) {
          return DeviceError(name_ + " is damaged or cut off at frame " + std::to_string(number) +
                             ", counted from 0; copy or record it again");
        }
        if (MonotonicSeconds() - whole_s < limits_.silence_s) continue;
        return DeviceError(name_ +
                           " sends damaged pictures only; check its cable, or choose a lower resolution or "
                           "another stream_format");
      }
      whole_s = MonotonicSeconds();
      if (picture.image.size() != size_) {
        return DeviceError(name_ + " sends pictures of " + SizeText(picture.image.size()) + " pixels, but " +
                           SizeText(size_) + " is expected; set camera.resolution_px to what it can do");
      }
      if (!begun) {
        begun = true;
        Warn(input->Begin());
        if (input->CanBeSet()) under_way_ = kUnderWay + 1;  // this one, too
      }
      if (under_way_ > 0) {
        --under_way_;
        continue;
      }
      Give({std::move(picture.image), picture.time_s, number});
    }
    return std::nullopt;
  }

  void Warn(const std::vector<std::string>& warnings) {
    const std::lock_guard lock(exchange_->mutex);
    AddWarnings(exchange_->warnings, warnings);
  }

  // Between pictures: sets the exposure that was asked for. False when the reader is to stop.
  bool Continue(VideoInput& input) {
    std::unique_lock lock(exchange_->mutex);
    if (kind_ == VideoKind::kRecording)
      exchange_->changed.wait(lock, [this] { return exchange_->stop || exchange_->frames.size() < kKept; });
    if (exchange_->wanted) {
      const FrameLight light = *exchange_->wanted;
      lock.unlock();
      const std::vector<std::string> warnings = input.Expose(light);
      if (input.CanBeSet() && light != exposed_for_) under_way_ = kUnderWay;
      exposed_for_ = light;
      lock.lock();
      AddWarnings(exchange_->warnings, warnings);
      exchange_->wanted.reset();
      exchange_->changed.notify_all();
    }
    return !exchange_->stop;
  }

  void Give(Frame frame) {
    const std::lock_guard lock(exchange_->mutex);
    frame.time_s = std::max(frame.time_s, last_time_s_);  // a driver's clock must not run backwards
    last_time_s_ = frame.time_s;
    if (exchange_->frames.size() >= kKept) exchange_->frames.pop_front();
    exchange_->frames.push_back(std::move(frame));
    exchange_->opened = true;
    exchange_->changed.notify_all();
  }

  const std::shared_ptr<Exchange> exchange_;
  const VideoKind kind_;
  const std::string name_;
  const VideoOpener opener_;
  const cv::Size size_;
  const VideoLimits limits_;
  double last_time_s_ = 0.0;
  int under_way_ = 0;  // pictures that were begun with earlier settings, to be passed over
  std::optional<FrameLight> exposed_for_;
};

class VideoFrames : public FrameSource {
 public:
  VideoFrames(VideoKind kind, std::string name, VideoOpener opener, cv::Size size, const VideoLimits& limits)
      : kind_(kind), name_(std::move(name)), size_(size), limits_(limits) {
    thread_ = std::thread([reader = Reader(exchange_, kind_, name_, std::move(opener), size_,
                                           limits_)]() mutable { reader.Run(); });
  }
  VideoFrames(const VideoFrames&) = delete;
  VideoFrames& operator=(const VideoFrames&) = delete;

  ~VideoFrames() override {
    std::unique_lock lock(exchange_->mutex);
    exchange_->stop = true;
    exchange_->changed.notify_all();
    const double limit_s = std::max(limits_.open_s, limits_.silence_s) + kPatience_s;
    const bool ended =
        exchange_->changed.wait_for(lock, Duration(limit_s), [this] { return exchange_->ended; });
    lock.unlock();
    if (ended) {
      thread_.join();
    } else {
      thread_.detach();  // it hangs in a call that nobody can end
    }
  }

  // Until the first frame has come.
  Status WaitUntilOpen(const Context& context) {
    std::unique_lock lock(exchange_->mutex);
    const double until_s = MonotonicSeconds() + limits_.open_s + kPatience_s;
    while (!exchange_->opened && !exchange_->error) {
      if (context.IsCancelled()) return Cancelled();
      if (MonotonicSeconds() > until_s) {
        return DeviceError(name_ + " gave no picture within " + Seconds(limits_.open_s) +
                           "; check that it is connected and that no other program uses it");
      }
      exchange_->changed.wait_for(lock, kCancelCheck);
    }
    return exchange_->opened ? Status() : Status(*exchange_->error);
  }

  Result<Frame> Next(double timeout_s) override {
    std::unique_lock lock(exchange_->mutex);
    exchange_->changed.wait_for(lock, Duration(timeout_s),
                                [this] { return !exchange_->frames.empty() || exchange_->error; });
    if (!exchange_->frames.empty()) {
      Frame frame = std::move(exchange_->frames.front());
      exchange_->frames.pop_front();
      exchange_->changed.notify_all();
      return frame;
    }
    if (exchange_->error) return *exchange_->error;
    return DeviceError(name_ + " sent no picture within " + Seconds(timeout_s) +
                       "; check that it is connected");
  }

  Status ExposeFor(FrameLight light) override {
    if (kind_ != VideoKind::kCamera) return {};  // set up by whoever made the stream or the recording
    std::unique_lock lock(exchange_->mutex);
    exchange_->wanted = light;
    exchange_->changed.wait_for(lock, Duration(limits_.silence_s + kPatience_s),
                                [this] { return !exchange_->wanted || exchange_->error; });
    if (exchange_->error) return *exchange_->error;
    if (exchange_->wanted) return DeviceError(name_ + " hangs: its exposure cannot be set; plug it in again");
    return {};
  }

  cv::Size size() const override { return size_; }
  std::string name() const override { return name_; }
  std::vector<std::string> warnings() const override {
    const std::lock_guard lock(exchange_->mutex);
    return exchange_->warnings;
  }
  bool never_repeats() const override { return kind_ != VideoKind::kRecording; }

 private:
  const VideoKind kind_;
  const std::string name_;
  const cv::Size size_;
  const VideoLimits limits_;
  const std::shared_ptr<Exchange> exchange_ = std::make_shared<Exchange>();
  std::thread thread_;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> OpenVideoFrames(VideoKind kind, const std::string& name,
                                                     VideoOpener opener, cv::Size size,
                                                     const VideoLimits& limits, const Context& context) {
  auto frames = std::make_unique<VideoFrames>(kind, name, std::move(opener), size, limits);
  DORSUM_RETURN_IF_ERROR(frames->WaitUntilOpen(context));
  return std::unique_ptr<FrameSource>(std::move(frames));
}

Result<std::unique_ptr<FrameSource>> OpenVideoFrames(VideoKind kind, const std::string& place,
                                                     const CameraDesign& design, const VideoLimits& limits,
                                                     const Context& context) {
  VideoLimits longer = limits;  // a long exposure is no silence
  longer.silence_s += 3.0 * std::max(design.laser_exposure_s, design.led_exposure_s);
  const auto opener = [kind, place, design, longer] { return VideoInput::Open(kind, place, design, longer); };
  return OpenVideoFrames(kind, VideoName(kind, place), opener, {design.width, design.height}, longer,
                         context);
}

}  // namespace dorsum
