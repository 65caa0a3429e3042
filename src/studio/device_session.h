// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/context.h"
#include "device/device.h"

namespace dorsum {

// What the window knows of an open device.
struct DeviceFacts {
  std::string name;  // as it was asked for
  DeviceDescription description;
  std::string camera;
  ControllerInfo controller;
  std::vector<std::string> warnings;
  bool is_virtual = false;
};

// The device in a thread of its own: a live picture while nothing else is asked for, and one task after the
// other that has camera and lights to itself. Lives in the window's thread; everything it says, it says
// there. The lights go off when the preview stops, after each task, and when it goes.
class DeviceSession : public QObject {
  Q_OBJECT

 public:
  explicit DeviceSession(QObject* parent = nullptr);
  ~DeviceSession() override;

  // Opens another device in place of the one before. Opened() or Failed() follows.
  void Open(const std::string& which);
  void Close();
  const std::optional<DeviceFacts>& facts() const { return facts_; }

  // Live pictures under these lights, as fast as the window takes them. Renewed until StopPreview().
  void StartPreview(const ChannelSet& lights, FrameLight light);
  void StopPreview();

  // A task with the device; then `done` with its result in this object's thread. Waits for those before it.
  // With no device, `done` gets a device error.
  template <class T>
  void Run(const QString& title, std::function<Result<T>(Device&, const Context&)> work,
           std::function<void(Result<T>)> done) {
    Queue(title, [work = std::move(work), done = std::move(done)](Device* device, const Context& context) {
      auto result =
          std::make_shared<Result<T>>(device != nullptr ? work(*device, context) : Result<T>(NoDevice()));
      return [result, done] { done(std::move(*result)); };
    });
  }
  bool busy() const { return tasks_ > 0; }
  void Cancel() { cancel_ = true; }  // the task that runs

 signals:
  void Opened();
  void Closed();
  void Failed(const dorsum::Error& error);  // opening, or the preview
  void FrameReady(const cv::Mat& picture);  // of the preview, CV_8UC3
  void LitChanged(
      quint64 channels);  // what is lit at the preview, as the controller says; bit n is channel n
  void TaskStarted(const QString& title);
  void Progressed(const QString& stage, double fraction);
  void TaskFinished();  // after `done`

 private:
  using Report = std::function<void()>;  // to be called in this object's thread
  using Task = std::function<Report(Device*, const Context&)>;
  static Error NoDevice();

  void Queue(const QString& title, Task task);
  void Tell(Report report);
  void Work();
  void DoTask(const QString& title, const Task& task);
  void Preview();
  void LookAtLights();
  void PutOut();
  void OpenNow(const std::string& which);

  struct Wish {
    ChannelSet lights;
    FrameLight light = FrameLight::kLeds;
  };
  std::optional<DeviceFacts> facts_;
  int tasks_ = 0;

  std::atomic<bool> cancel_ = false, frame_on_its_way_ = false;
  std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::deque<std::pair<QString, Task>> queue_;
  std::optional<Wish> preview_;
  bool stop_ = false;

  std::optional<Device> device_;   // of the thread
  std::optional<ChannelSet> lit_;  // by the preview
  double lit_at_s_ = 0.0, asked_at_s_ = 0.0;
  quint64 told_lit_ = 0;
  std::thread thread_;  // last: it uses all of them
};

}  // namespace dorsum
