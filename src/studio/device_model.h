// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <optional>
#include <vector>

#include "jobs/doctor.h"
#include "studio/workbench.h"

namespace dorsum {

// One light, or several that only go together, as a person switches them by hand.
struct LightSwitch {
  QString name;
  ChannelSet channels;
  bool laser = false;
  bool on = false;        // as it was wished for
  double off_at_s = 0.0;  // of a laser that is on: when it goes off by itself, MonotonicSeconds()
};

// A line of the camera's settings.
struct CameraSetting {
  QString name, value;
  bool failed = false;  // the camera could not be set so; `value` says what it does
};

// The device page without its widgets: opening, lights by hand, the examination. Lights are only ever lit
// while somebody watches, and a laser goes off by itself: after the controller's own limit, or, where the
// controller has none, after `hand_limit_s`.
class DeviceModel : public QObject {
  Q_OBJECT

 public:
  explicit DeviceModel(Workbench* workbench, double hand_limit_s = 10.0, QObject* parent = nullptr);

  // What was opened last, the newest first; the virtual device when there is nothing.
  static QStringList Recent();
  void Open(const QString& which);
  void Close();

  // Somebody looks at the live picture, or no longer: then all lights go off.
  void Watch(bool watched);

  const std::vector<LightSwitch>& switches() const { return switches_; }
  void Switch(std::size_t index, bool on);
  void AllOff();
  double laser_limit_s() const;
  double SecondsLeft(std::size_t index) const;  // 0 for what is off or is no laser

  QString SafetyWords() const;  // the limits under which lights stand
  QString LitWords() const;     // what is on now, as the controller says
  std::vector<CameraSetting> CameraSettings() const;

  // Examines the open device; where none is open, the machine, and why `which` does not open.
  void Examine(const QString& which);
  const std::optional<DoctorReport>& report() const { return report_; }

 signals:
  void DeviceChanged();
  void LightsChanged();
  void Examined();

 private:
  void BeOpen();
  void BeGone();
  void Show();
  void CheckLimits();

  Workbench* workbench_;
  double hand_limit_s_;
  bool watched_ = false;
  std::vector<LightSwitch> switches_;
  ChannelSet lit_;
  std::optional<DoctorReport> report_;
  QTimer clock_;
};

}  // namespace dorsum
