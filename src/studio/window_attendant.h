// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "device/attendant.h"
#include "device/device.h"

namespace dorsum {

// What a window hears of a calibration series that is being taken.
struct SeriesNews {
  enum class Kind {
    kAsked,    // `words` say what to arrange for `step`; the series waits
    kGoing,    // it waits no longer
    kTold,     // `words` say what was seen
    kBoard,    // `corners` of a board that counts, px
    kDone,     // the pictures of `step` are there
    kPicture,  // a live picture
  };
  Kind kind = Kind::kTold;
  SeriesStep step = {};
  std::string words = {};
  std::vector<cv::Point2f> corners = {};
  cv::Mat picture = {};  // CV_8UC3
};

// What a window says to a series. Safe to use from several threads.
class SeriesGate {
 public:
  void Next();                // the arrangement stands
  void Stop();                // give up
  void GoOn(bool by_itself);  // of a virtual device: without being asked
  void Hide(bool hidden);     // nobody sees the window: the guiding stripes go off until somebody does
  void PictureTaken() { on_its_way_ = false; }

 private:
  friend class WindowAttendant;
  std::mutex mutex_;  // guards the next four
  std::condition_variable changed_;
  bool next_ = false, stop_ = false, by_itself_ = false, hidden_ = false;
  std::atomic<bool> on_its_way_ = false;  // a picture: a window that is slow misses some, and piles up none
};

// Asks the person at a window, who sees the live picture with the guiding stripes meanwhile; steps without
// stripes are seen under the LEDs. Before a virtual device things are laid down by themselves after the same
// word. `tell` is called in the device's thread.
class WindowAttendant : public Attendant {
 public:
  WindowAttendant(Device& device, std::shared_ptr<SeriesGate> gate,
                  std::function<void(const SeriesNews&)> tell);

  Status Arrange(const SeriesStep& step, const std::string& words, const std::function<Status()>& keep_lit,
                 const Context& context) override;
  void Tell(const std::string& words) override;
  void SawBoard(const std::vector<cv::Point2f>& corners) override;
  void StepDone(const SeriesStep& step) override;

 private:
  Status WaitForNext(const SeriesStep& step, const std::function<Status()>& keep_lit, const Context& context);
  Status Light(const SeriesStep& step, const std::function<Status()>& keep_lit) const;
  Status ShowPicture();

  Device& device_;
  std::shared_ptr<SeriesGate> gate_;
  std::function<void(const SeriesNews&)> tell_;
  std::unique_ptr<Attendant> hands_;  // of a virtual device
};

}  // namespace dorsum
