// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "captures/capture.h"
#include "jobs/reconstruct.h"
#include "studio/device_session.h"
#include "studio/job_runner.h"

namespace dorsum {

// A capture with its surface, as all pages see it. Never changed once it is made.
struct Scan {
  std::string name;                                     // for people
  std::filesystem::path folder;                         // of the capture; empty as long as it is not kept
  CaptureImages capture;                                // empty where only a mesh was opened
  std::shared_ptr<const ReadyCalibration> calibration;  // none where only a mesh was opened
  Reconstruction surface;
  double seconds = 0.0;  // that the computation took
};

// What the pages share: the device, the calibration, the scan that is looked at, and the jobs that run. No
// widgets.
class Workbench : public QObject {
  Q_OBJECT

 public:
  explicit Workbench(QObject* parent = nullptr) : QObject(parent) {}

  DeviceSession& device() { return device_; }
  JobRunner& jobs() { return jobs_; }

  const std::shared_ptr<const ReadyCalibration>& calibration() const { return calibration_; }
  const std::filesystem::path& calibration_path() const { return calibration_path_; }
  // Reads it beside the window; CalibrationChanged() or Failed() follows.
  void LoadCalibration(const std::filesystem::path& path);

  const std::shared_ptr<const Scan>& scan() const { return scan_; }
  void SetScan(std::shared_ptr<const Scan> scan);
  // A capture folder (reconstructed with the calibration), or the PLY of a surface or of points.
  void OpenPath(const std::filesystem::path& path);

  void Fail(const Error& error) { emit Failed(error); }

 signals:
  void CalibrationChanged();
  void ScanChanged();
  void Failed(const dorsum::Error& error);  // a sentence for the person, with a way out

 private:
  std::shared_ptr<const ReadyCalibration> calibration_;
  std::filesystem::path calibration_path_;
  std::shared_ptr<const Scan> scan_;
  JobRunner jobs_;
  DeviceSession device_;
};

// What a PLY file holds: a mesh, or the points of one.
Result<std::shared_ptr<const Scan>> ReadSurface(const std::filesystem::path& path);

// Reconstructs images that are in memory. `folder` may be empty.
Result<std::shared_ptr<const Scan>> MakeScan(std::string name, std::filesystem::path folder,
                                             CaptureImages capture,
                                             std::shared_ptr<const ReadyCalibration> calibration,
                                             const ReconstructOptions& options, const Context& context);

}  // namespace dorsum
