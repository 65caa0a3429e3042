// SPDX-License-Identifier: Apache-2.0
#include "studio/device_model.h"

#include <QDir>
#include <QPointer>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <map>

#include "studio/library_words.h"

namespace dorsum {
namespace {

constexpr int kTick_ms = 100;
constexpr int kRecent = 8;
constexpr const char* kRecentKey = "device/recent";

std::vector<LightSwitch> SwitchesOf(const DeviceDescription& description) {
  std::vector<LightSwitch> switches;
  std::map<int, int> leds;  // how many hang on each channel
  for (const LedDesign& led : description.leds) ++leds[led.channel];
  for (const auto& [channel, count] : leds) {
    LightSwitch one;
    one.name =
        leds.size() == 1 ? DeviceModel::tr("LEDs") : DeviceModel::tr("LEDs of channel %1").arg(channel);
    one.channels.set(static_cast<std::size_t>(channel));
    switches.push_back(one);
  }
  for (int k = 0; k < static_cast<int>(description.lasers.size()); ++k) {
    LightSwitch one;
    one.name = DeviceModel::tr("Laser %1").arg(k);
    one.channels = LaserChannel(description, k);
    one.laser = true;
    switches.push_back(one);
  }
  return switches;
}

QString Seconds(double s) { return DeviceModel::tr("%1 s").arg(s); }

QString OrLeft(bool set, const QString& value) {
  return set ? value : DeviceModel::tr("left as the camera has it");
}

}  // namespace

DeviceModel::DeviceModel(Workbench* workbench, double hand_limit_s, QObject* parent)
    : QObject(parent), workbench_(workbench), hand_limit_s_(hand_limit_s) {
  clock_.setInterval(kTick_ms);
  connect(&clock_, &QTimer::timeout, this, &DeviceModel::CheckLimits);
  DeviceSession& device = workbench_->device();
  connect(&device, &DeviceSession::Opened, this, &DeviceModel::BeOpen);
  connect(&device, &DeviceSession::Closed, this, &DeviceModel::BeGone);
  connect(&device, &DeviceSession::Failed, this, &DeviceModel::BeGone);
  connect(&device, &DeviceSession::LitChanged, this, [this](quint64 channels) {
    lit_ = ChannelSet(channels);
    emit LightsChanged();
  });
  if (device.facts()) switches_ = SwitchesOf(device.facts()->description);
}

QStringList DeviceModel::Recent() {
  QStringList recent = QSettings().value(kRecentKey).toStringList();
  if (!recent.contains("virtual")) recent.append("virtual");
  return recent;
}

void DeviceModel::Open(const QString& which) {
  const QString name = which.trimmed();
  if (name.isEmpty()) {
    return workbench_->Fail(UsageError("no device is named; choose a device.toml, or write virtual"));
  }
  AllOff();
  workbench_->device().Open(name.toStdString());
}

void DeviceModel::Close() {
  AllOff();
  workbench_->device().Close();
}

void DeviceModel::BeOpen() {
  const DeviceFacts& facts = *workbench_->device().facts();
  switches_ = SwitchesOf(facts.description);
  report_.reset();
  QSettings settings;
  QStringList recent = settings.value(kRecentKey).toStringList();
  const QString name = QString::fromStdString(facts.name);
  recent.removeAll(name);
  recent.prepend(name);
  settings.setValue(kRecentKey, QStringList(recent.mid(0, kRecent)));
  emit DeviceChanged();
  Watch(watched_);
}

// It was closed, did not open, or failed while it was looked at. In the last case it is still there, and may
// be opened again.
void DeviceModel::BeGone() {
  if (!workbench_->device().facts()) switches_.clear();
  for (LightSwitch& one : switches_) one.on = false;
  clock_.stop();
  emit DeviceChanged();
  emit LightsChanged();
}

void DeviceModel::Watch(bool watched) {
  watched_ = watched;
  for (LightSwitch& one : switches_) one.on = watched && !one.laser;
  if (watched) return Show();
  clock_.stop();
  workbench_->device().StopPreview();
  emit LightsChanged();
}

void DeviceModel::Show() {
  if (watched_ && workbench_->device().facts()) {
    ChannelSet wanted;
    bool leds = false, lasers = false;
    for (const LightSwitch& one : switches_) {
      if (!one.on) continue;
      wanted |= one.channels;
      (one.laser ? lasers : leds) = true;
    }
    workbench_->device().StartPreview(wanted, leds ? FrameLight::kLeds : FrameLight::kLaser);
    if (lasers) {
      clock_.start();
    } else {
      clock_.stop();
    }
  }
  emit LightsChanged();
}

void DeviceModel::Switch(std::size_t index, bool on) {
  if (!watched_) return;
  LightSwitch& one = switches_.at(index);
  one.on = on;
  one.off_at_s = on && one.laser ? MonotonicSeconds() + laser_limit_s() : 0.0;
  Show();
}

void DeviceModel::AllOff() {
  for (LightSwitch& one : switches_) one.on = false;
  Show();
}

double DeviceModel::laser_limit_s() const {
  const auto& facts = workbench_->device().facts();
  return facts && facts->controller.on_limit_s > 0.0 ? facts->controller.on_limit_s : hand_limit_s_;
}

double DeviceModel::SecondsLeft(std::size_t index) const {
  const LightSwitch& one = switches_.at(index);
  return one.on && one.laser ? std::max(0.0, one.off_at_s - MonotonicSeconds()) : 0.0;
}

void DeviceModel::CheckLimits() {
  bool over = false;
  for (std::size_t i = 0; i < switches_.size(); ++i) {
    if (!switches_[i].on || !switches_[i].laser || SecondsLeft(i) > 0.0) continue;
    switches_[i].on = false;
    over = true;
  }
  if (over) return Show();
  emit LightsChanged();  // the seconds that are left
}

QString DeviceModel::SafetyWords() const {
  const auto& facts = workbench_->device().facts();
  if (!facts) return tr("No device is open, so no light can be switched on.");
  const ControllerInfo& info = facts->controller;
  QString words = tr("A laser switched on here goes off by itself after %1.").arg(Seconds(laser_limit_s()));
  if (info.silence_limit_s > 0.0) {
    words += " " + tr("The controller itself puts all lights out when it hears nothing for %1.")
                       .arg(Seconds(info.silence_limit_s));
  } else {
    words += " " + tr("The controller has no limit of its own.");
  }
  return words + " " + tr("All lights go off when this page is left.");
}

QString DeviceModel::LitWords() const {
  if (!workbench_->device().facts()) return {};
  QStringList names;
  ChannelSet known;
  for (const LightSwitch& one : switches_) {
    if ((one.channels & lit_).any()) names.append(one.name);
    known |= one.channels;
  }
  for (std::size_t i = 0; i < lit_.size(); ++i) {
    if (lit_[i] && !known[i]) names.append(tr("channel %1").arg(i));
  }
  return names.isEmpty() ? tr("The controller says: all lights are off.")
                         : tr("The controller says these are on: %1.").arg(names.join(", "));
}

std::vector<CameraSetting> DeviceModel::CameraSettings() const {
  const auto& facts = workbench_->device().facts();
  if (!facts) return {};
  const CameraDesign& c = facts->description.camera;
  const bool exposure = c.laser_exposure_s > 0.0 || c.led_exposure_s > 0.0;
  std::vector<CameraSetting> rows = {
      {tr("Camera"), InOwnWords(facts->camera)},
      {tr("Resolution"), tr("%1 × %2 pixels").arg(c.width).arg(c.height)},
      {tr("Files"), c.format == "png" ? tr("PNG") : tr("JPEG, quality %1").arg(c.jpeg_quality)},
      {tr("Stream"), c.stream_format == "raw" ? tr("raw pictures") : tr("JPEG pictures")},
      {tr("Exposure under lasers"), OrLeft(exposure, Seconds(c.laser_exposure_s))},
      {tr("Exposure under LEDs"), OrLeft(exposure, Seconds(c.led_exposure_s))},
      {tr("Gain"), OrLeft(c.gain >= 0, QString::number(c.gain))},
      {tr("Focus"), OrLeft(c.focus >= 0, QString::number(c.focus))},
      {tr("White balance"), OrLeft(c.white_balance_k > 0, tr("%1 K").arg(c.white_balance_k))},
  };
  for (const std::string& warning : facts->warnings) {
    rows.push_back({tr("Could not be set"), InOwnWords(warning), true});
  }
  return rows;
}

void DeviceModel::Examine(const QString& which) {
  DoctorRequest request;
  request.calibration_path = workbench_->calibration_path();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  request.data_dir = (QDir(documents).exists() ? documents : QDir::homePath()).toStdString();
  const auto done = [guard = QPointer(this)](Result<DoctorReport> report) {
    if (!guard) return;
    if (report.ok()) {
      guard->report_ = *report;
    } else {
      guard->workbench_->Fail(report.error());
    }
    emit guard->Examined();
  };
  if (workbench_->device().facts()) {
    workbench_->device().Run<DoctorReport>(
        tr("Examining the device"),
        [request](Device& device, const Context& context) {
          return ExamineOpenDevice(device, request, context);
        },
        done);
    return;
  }
  if (workbench_->jobs().busy()) {
    return workbench_->Fail(UsageError("something else is being done; wait for it, or cancel it"));
  }
  request.device = which.trimmed().toStdString();
  workbench_->jobs().Run<DoctorReport>(
      tr("Examining this machine"),
      [request](const Context& context) { return ExamineDevice(request, context); }, done);
}

}  // namespace dorsum
