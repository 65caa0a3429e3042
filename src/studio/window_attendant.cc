// SPDX-License-Identifier: Apache-2.0
#include "studio/window_attendant.h"

#include <chrono>
#include <utility>

#include "jobs/live_series.h"

namespace dorsum {
namespace {

constexpr double kRenew_s = 0.5;       // of the guiding stripes
constexpr double kFrameLimit_s = 2.0;  // for one live picture
constexpr auto kPause = std::chrono::milliseconds(20);

}  // namespace

void SeriesGate::Next() {
  const std::lock_guard lock(mutex_);
  next_ = true;
  changed_.notify_all();
}

void SeriesGate::Stop() {
  const std::lock_guard lock(mutex_);
  stop_ = true;
  changed_.notify_all();
}

void SeriesGate::GoOn(bool by_itself) {
  const std::lock_guard lock(mutex_);
  by_itself_ = by_itself;
  changed_.notify_all();
}

void SeriesGate::Hide(bool hidden) {
  const std::lock_guard lock(mutex_);
  hidden_ = hidden;
  changed_.notify_all();
}

WindowAttendant::WindowAttendant(Device& device, std::shared_ptr<SeriesGate> gate,
                                 std::function<void(const SeriesNews&)> tell)
    : device_(device), gate_(std::move(gate)), tell_(std::move(tell)) {
  if (device_.bench) hands_ = MakeVirtualAttendant(device_.bench);
}

Status WindowAttendant::Arrange(const SeriesStep& step, const std::string& words,
                                const std::function<Status()>& keep_lit, const Context& context) {
  {
    const std::lock_guard lock(gate_->mutex_);
    gate_->next_ = false;
  }
  tell_({.kind = SeriesNews::Kind::kAsked, .step = step, .words = words});
  DORSUM_RETURN_IF_ERROR(WaitForNext(step, keep_lit, context));
  tell_({.kind = SeriesNews::Kind::kGoing, .step = step});
  if (!hands_) return {};
  DORSUM_RETURN_IF_ERROR(hands_->Arrange(step, words, keep_lit, context));
  DORSUM_RETURN_IF_ERROR(Light(step, keep_lit));
  return ShowPicture();
}

Status WindowAttendant::WaitForNext(const SeriesStep& step, const std::function<Status()>& keep_lit,
                                    const Context& context) {
  double lit_at_s = -1.0;
  while (true) {
    bool hidden = false;
    {
      std::unique_lock lock(gate_->mutex_);
      gate_->changed_.wait_for(lock, kPause);
      if (gate_->stop_ || context.IsCancelled()) return Cancelled();
      if (gate_->next_ || (gate_->by_itself_ && hands_)) return {};
      hidden = gate_->hidden_;
    }
    if (hidden) {
      if (lit_at_s >= 0.0) DORSUM_RETURN_IF_ERROR(device_.lights->Set({}));
      lit_at_s = -1.0;
      continue;
    }
    if (lit_at_s < 0.0 || MonotonicSeconds() - lit_at_s > kRenew_s) {
      DORSUM_RETURN_IF_ERROR(Light(step, keep_lit));
      lit_at_s = MonotonicSeconds();
    }
    DORSUM_RETURN_IF_ERROR(ShowPicture());
  }
}

Status WindowAttendant::Light(const SeriesStep& step, const std::function<Status()>& keep_lit) const {
  if (GuideOf(step, device_.description).any()) {
    DORSUM_RETURN_IF_ERROR(device_.frames->ExposeFor(FrameLight::kLaser));
    return keep_lit();
  }
  DORSUM_RETURN_IF_ERROR(device_.frames->ExposeFor(FrameLight::kLeds));
  return device_.lights->Set(LedChannels(device_.description));
}

Status WindowAttendant::ShowPicture() {
  DORSUM_ASSIGN_OR_RETURN(Frame frame, device_.frames->Next(kFrameLimit_s));
  if (!gate_->on_its_way_.exchange(true)) {
    tell_({.kind = SeriesNews::Kind::kPicture, .picture = std::move(frame.image)});
  }
  return {};
}

void WindowAttendant::Tell(const std::string& words) {
  tell_({.kind = SeriesNews::Kind::kTold, .words = words});
}

void WindowAttendant::SawBoard(const std::vector<cv::Point2f>& corners) {
  tell_({.kind = SeriesNews::Kind::kBoard, .corners = corners});
}

void WindowAttendant::StepDone(const SeriesStep& step) {
  tell_({.kind = SeriesNews::Kind::kDone, .step = step});
}

}  // namespace dorsum
