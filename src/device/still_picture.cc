// SPDX-License-Identifier: Apache-2.0
#include "device/still_picture.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "device/device_error.h"
#include "device/picture_change.h"

namespace dorsum {
namespace {

constexpr double kSlice_s = 0.2;     // how long an interruption may wait for a frame
constexpr int kStaleFrames = 5;      // a driver's queue, and one
constexpr double kStaleShare = 0.8;  // of the time-out: then an unchanged picture is taken as it is
constexpr double kFrozen_s = 1.0;    // a frame repeated for so long, and so often, is no duplicate
constexpr int kFrozenFrames = 5;
constexpr int kBlack = 4;  // grey levels: below, a sensor's noise may be cut off, so that frames do repeat

std::string SizeText(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

std::string Seconds(double s) {
  std::ostringstream out;
  out.precision(3);
  out << s << " s";
  return out.str();
}

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size()) return false;
  const std::size_t bytes = a.elemSize() * static_cast<std::size_t>(a.cols);
  for (int row = 0; row < a.rows; ++row) {
    if (std::memcmp(a.ptr(row), b.ptr(row), bytes) != 0) return false;
  }
  return true;
}

bool IsBlack(const cv::Mat& image) {
  double low = 0.0, high = 0.0;
  cv::minMaxLoc(image.reshape(1), &low, &high);
  return high < kBlack;
}

// Judges the frames of one still picture as they come.
class Settling {
 public:
  Settling(const FrameSource& frames, double changed_at_s, const StillOptions& options)
      : frames_(frames), changed_at_s_(changed_at_s), options_(options), now_s_(MonotonicSeconds()) {
    deadline_s_ = now_s_ + options.timeout_s;
    stale_until_s_ = std::min(changed_at_s + options.stale_s, now_s_ + kStaleShare * options.timeout_s);
    if (options.before.size() == frames.size() && options.before.type() == CV_8UC3)
      reference_ = TilesOf(options.before);
  }

  double Left() {
    now_s_ = std::max(now_s_, MonotonicSeconds());
    return deadline_s_ - now_s_;
  }

  // Takes in a frame; true when the average is complete.
  Result<bool> Add(const Frame& frame) {
    if (frame.image.size() != frames_.size() || frame.image.type() != CV_8UC3) {
      return DeviceError(frames_.name() + " sent a picture of " + SizeText(frame.image.size()) +
                         " pixels instead of " + SizeText(frames_.size()) + "; start again");
    }
    now_s_ = std::max(now_s_, frame.time_s);
    ++seen_;
    if (frames_.never_repeats() && last_ && SameBytes(last_->image, frame.image) && !IsBlack(frame.image)) {
      ++repeats_;
      if (repeats_ >= kFrozenFrames && frame.time_s - last_->time_s >= kFrozen_s) {
        return DeviceError(frames_.name() +
                           " is frozen: it sends the same picture again and again; unplug it and plug it in");
      }
      return false;  // a duplicate says nothing
    }
    repeats_ = 0;
    last_ = frame;
    const PictureTiles tiles = TilesOf(frame.image);
    if (!reference_) reference_ = tiles;
    if (frame.time_s >= changed_at_s_ + options_.delay_s) {
      Judge(frame, tiles);
    } else {
      count_ = 0;
    }
    previous_ = tiles;
    return count_ == options_.average;
  }

  cv::Mat Average() const {
    if (count_ == 1) return last_->image.clone();
    cv::Mat rounded(sum_.size(), CV_8UC3);
    for (int row = 0; row < sum_.rows; ++row) {
      const auto* from = sum_.ptr<int>(row);
      auto* to = rounded.ptr(row);
      for (int i = 0; i < 3 * sum_.cols; ++i) to[i] = static_cast<uchar>((from[i] + count_ / 2) / count_);
    }
    return rounded;
  }

  Error WhyNot() const {
    if (seen_ == 0) {
      return DeviceError(frames_.name() + " sent no picture within " + Seconds(options_.timeout_s) +
                         "; check that it is connected and that no other program uses it");
    }
    if (repeats_ > 0) {
      return DeviceError(frames_.name() +
                         " is frozen: it sends the same picture again and again; unplug "
                         "it and plug it in");
    }
    if (fresh_ < 2) {
      return DeviceError(frames_.name() + " sent only " + std::to_string(fresh_) +
                         " picture(s) after the light changed, within " + Seconds(options_.timeout_s) +
                         "; it is too slow: shorten the exposure or give it more time");
    }
    return DeviceError("the picture of " + frames_.name() + " did not settle within " +
                       Seconds(options_.timeout_s) + ": frames still differ by " + LastChange() +
                       " grey levels; keep the hand still, shade other lights, and set a fixed exposure "
                       "(camera.laser_exposure_s and led_exposure_s)");
  }

 private:
  void Judge(const Frame& frame, const PictureTiles& tiles) {
    ++fresh_;
    if (previous_) last_change_ = ChangeBetween(*previous_, tiles);
    if (!previous_ || !Agree(last_change_)) {
      calm_ = 0;
      count_ = 0;
      // A difference to what was seen before is the light change, or something that must settle first.
      return;
    }
    ++calm_;
    if (!IsNew(tiles)) {
      count_ = 0;
      return;
    }
    if (count_ == 0) sum_ = cv::Mat::zeros(frame.image.size(), CV_32SC3);
    if (options_.average > 1) cv::add(sum_, frame.image, sum_, cv::noArray(), CV_32S);
    ++count_;
  }

  // Whether a frame that agrees with the one before it shows the light after the change.
  bool IsNew(const PictureTiles& tiles) const {
    if (frames_.stamps_exposure() || count_ > 0) return true;
    if (ShowsOtherLight(ChangeBetween(*reference_, tiles))) return true;
    return now_s_ >= stale_until_s_ && calm_ >= kStaleFrames;
  }

  std::string LastChange() const {
    std::ostringstream out;
    out.precision(2);
    out << last_change_.worst_band;
    return out.str();
  }

  const FrameSource& frames_;
  const double changed_at_s_;
  const StillOptions& options_;
  double now_s_, deadline_s_ = 0.0, stale_until_s_ = 0.0;
  std::optional<PictureTiles> reference_, previous_;
  std::optional<Frame> last_;
  PictureChange last_change_;
  cv::Mat sum_;
  int seen_ = 0, fresh_ = 0;    // frames at all, and since the change
  int calm_ = 0, repeats_ = 0;  // in a row: that agree, and that are equal
  int count_ = 0;               // frames in the sum
};

}  // namespace

Result<cv::Mat> TakeStill(FrameSource& frames, double changed_at_s, const StillOptions& options,
                          const Context& context) {
  if (options.average < 1 || options.average > 64 || !(options.timeout_s > 0.0))
    throw std::logic_error("TakeStill() with options out of range");
  Settling settling(frames, changed_at_s, options);
  for (double left = settling.Left(); left > 0.0; left = settling.Left()) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    const double wait_s = std::min(left, kSlice_s);
    const double asked_at_s = MonotonicSeconds();
    const Result<Frame> frame = frames.Next(wait_s);
    if (!frame.ok()) {
      // None in this slice of the time, perhaps in the next; a camera that is gone says so at once.
      if (MonotonicSeconds() - asked_at_s >= 0.9 * wait_s) continue;
      return frame.error();
    }
    DORSUM_ASSIGN_OR_RETURN(const bool complete, settling.Add(*frame));
    if (complete) return settling.Average();
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return settling.WhyNot();
}

}  // namespace dorsum
