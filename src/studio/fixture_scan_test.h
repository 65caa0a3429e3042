// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "calibration/calibration_file.h"
#include "captures/capture.h"
#include "jobs/scan_fixture_test.h"
#include "studio/workbench.h"

namespace dorsum {

template <class T>
T Need(Result<T> result) {
  if (!result.ok()) throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

// A capture of the scan fixture with its surface.
inline std::shared_ptr<const Scan> FixtureScan(const std::string& name) {
  const auto json = ScanFixture::CalibrationJson();
  auto ready = std::make_shared<const ReadyCalibration>(
      Need(PrepareCalibration(Need(ReadCalibration(json)), json.string())));
  const Camera& camera = ready->calibration.device.camera;
  const auto folder = ScanFixture::CaptureDir(name);
  CaptureImages capture = Need(LoadCapture(folder, {camera.width, camera.height}, {0, 1, 2}));
  return Need(MakeScan(name, folder, std::move(capture), std::move(ready), {}, {}));
}

}  // namespace dorsum
