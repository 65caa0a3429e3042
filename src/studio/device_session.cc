// SPDX-License-Identifier: Apache-2.0
#include "studio/device_session.h"

#include <QMetaObject>

#include "device/device_error.h"
#include "studio/progress_gate.h"

namespace dorsum {
namespace {

constexpr double kRenew_s = 2.0;       // a light in the preview is switched on again, for controllers' limits
constexpr double kAsk_s = 0.5;         // between two questions to the controller what is lit
constexpr double kFrameLimit_s = 2.0;  // for one frame of the preview

}  // namespace

Error DeviceSession::NoDevice() { return DeviceError("no device is open; choose one on the device page"); }

DeviceSession::DeviceSession(QObject* parent) : QObject(parent), thread_([this] { Work(); }) {}

DeviceSession::~DeviceSession() {
  cancel_ = true;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void DeviceSession::Open(const std::string& which) {
  StopPreview();
  Queue(tr("Opening the device"), [this, which](Device*, const Context&) -> Report {
    OpenNow(which);
    return [] {};
  });
}

void DeviceSession::Close() {
  StopPreview();
  Queue(tr("Closing the device"), [this](Device*, const Context&) -> Report {
    device_.reset();
    return [this] {
      facts_.reset();
      emit Closed();
    };
  });
}

void DeviceSession::OpenNow(const std::string& which) {
  device_.reset();
  Context context;
  context.cancel = &cancel_;
  Result<Device> opened = OpenDevice(which, context);
  if (!opened.ok()) {
    Tell([this, error = opened.error()] {
      facts_.reset();
      emit Failed(error);
    });
    return;
  }
  device_.emplace(std::move(opened).value());
  DeviceFacts facts{.name = device_->name,
                    .description = device_->description,
                    .camera = device_->frames->name(),
                    .controller = device_->lights->info(),
                    .warnings = device_->frames->warnings(),
                    .is_virtual = device_->bench != nullptr};
  Tell([this, facts = std::move(facts)] {
    facts_ = facts;
    emit Opened();
  });
}

void DeviceSession::StartPreview(const ChannelSet& lights, FrameLight light) {
  {
    const std::lock_guard lock(mutex_);
    preview_ = Wish{lights, light};
  }
  changed_.notify_all();
}

void DeviceSession::StopPreview() {
  {
    const std::lock_guard lock(mutex_);
    preview_.reset();
  }
  changed_.notify_all();
}

void DeviceSession::Queue(const QString& title, Task task) {
  ++tasks_;
  {
    const std::lock_guard lock(mutex_);
    queue_.emplace_back(title, std::move(task));
  }
  changed_.notify_all();
}

void DeviceSession::Tell(Report report) {
  QMetaObject::invokeMethod(this, std::move(report), Qt::QueuedConnection);
}

void DeviceSession::Work() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    if (!queue_.empty()) {
      const auto [title, task] = std::move(queue_.front());
      queue_.pop_front();
      lock.unlock();
      DoTask(title, task);
      lock.lock();
    } else if (preview_ && device_) {
      lock.unlock();
      Preview();
      lock.lock();
    } else {
      if (lit_ && device_) {  // not under the lock: a controller may take its time, the window must not wait
        lock.unlock();
        PutOut();
        lock.lock();
        continue;
      }
      changed_.wait(lock);
    }
  }
  device_.reset();
}

void DeviceSession::DoTask(const QString& title, const Task& task) {
  PutOut();
  cancel_ = false;
  Tell([this, title] { emit TaskStarted(title); });
  Context context;
  context.cancel = &cancel_;
  context.progress = [this, gate = ProgressGate()](std::string_view stage, double fraction) mutable {
    if (!gate.Passes(stage)) return;
    const QString name = QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()));
    Tell([this, name, fraction] { emit Progressed(name, fraction); });
  };
  Report report = task(device_ ? &*device_ : nullptr, context);
  if (device_) static_cast<void>(device_->lights->Set({}));
  Tell([this, report = std::move(report)] {
    --tasks_;
    report();
    emit TaskFinished();
  });
}

void DeviceSession::PutOut() {
  if (lit_ && device_) static_cast<void>(device_->lights->Set({}));
  lit_.reset();
  if (std::exchange(told_lit_, 0) != 0) Tell([this] { emit LitChanged(0); });
}

// A controller that does not answer is found by the next picture or the next renewal.
void DeviceSession::LookAtLights() {
  if (MonotonicSeconds() - asked_at_s_ < kAsk_s) return;
  asked_at_s_ = MonotonicSeconds();
  const Result<ChannelSet> on = device_->lights->On();
  if (!on.ok() || on->to_ullong() == told_lit_) return;
  told_lit_ = on->to_ullong();
  Tell([this, lit = told_lit_] { emit LitChanged(lit); });
}

void DeviceSession::Preview() {
  Wish wish;
  {
    const std::lock_guard lock(mutex_);
    if (!preview_) return;
    wish = *preview_;
  }
  Status status;
  // A window that takes no frames stands still: then nobody renews, and the controller's limit puts lasers
  // out.
  const bool renew = MonotonicSeconds() - lit_at_s_ > kRenew_s && !frame_on_its_way_;
  if (lit_ != wish.lights || renew) {
    status = device_->frames->ExposeFor(wish.light);
    if (status.ok()) status = device_->lights->Set(wish.lights);
    lit_ = wish.lights;
    lit_at_s_ = MonotonicSeconds();
    asked_at_s_ = 0.0;
  }
  if (status.ok()) {
    const Result<Frame> frame = device_->frames->Next(kFrameLimit_s);
    if (!frame.ok()) {
      status = frame.error();
    } else if (!frame_on_its_way_.exchange(true)) {  // a window that is slow misses frames, and piles up none
      Tell([this, picture = frame->image] {
        frame_on_its_way_ = false;
        emit FrameReady(picture);
      });
    }
  }
  if (status.ok()) return LookAtLights();
  StopPreview();
  Tell([this, error = status.error()] { emit Failed(error); });
}

}  // namespace dorsum
