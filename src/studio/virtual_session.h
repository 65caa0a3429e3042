// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>

#include "studio/workbench.h"

namespace dorsum {

// What can be done with the workbench's device where it is virtual: lay something before it, and let it
// calibrate itself. Its calibration is kept for the next time. No widgets.
class VirtualSession : public QObject {
  Q_OBJECT

 public:
  explicit VirtualSession(Workbench* workbench, QObject* parent = nullptr);

  bool is_open() const;
  void SetCache(const std::filesystem::path& cache) { cache_ = cache; }

  void Place(const QString& scene);  // as simulator/named_scene.h names it; Placed() follows
  void Calibrate();                  // Calibrated() or Failed() follows
  // The one that it made before, unless the person has chosen the calibration of something else.
  void LoadOwnCalibration();

 signals:
  void Placed();  // or not, which the workbench says
  void Calibrated(const std::filesystem::path& file);
  void Failed(const dorsum::Error& error);

 private:
  std::filesystem::path CalibrationDir() const;

  Workbench* workbench_;
  std::filesystem::path cache_;
};

}  // namespace dorsum
