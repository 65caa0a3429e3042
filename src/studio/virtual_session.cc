// SPDX-License-Identifier: Apache-2.0
#include "studio/virtual_session.h"

#include <QPointer>
#include <QStandardPaths>

#include "device/virtual_bench.h"
#include "studio/virtual_calibration.h"

namespace dorsum {

namespace fs = std::filesystem;

VirtualSession::VirtualSession(Workbench* workbench, QObject* parent)
    : QObject(parent),
      workbench_(workbench),
      cache_(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString()) {}

bool VirtualSession::is_open() const {
  const auto& facts = workbench_->device().facts();
  return facts && facts->is_virtual;
}

fs::path VirtualSession::CalibrationDir() const {
  return VirtualCalibrationDir(cache_, workbench_->device().facts()->name);
}

void VirtualSession::LoadOwnCalibration() {
  if (!is_open() || workbench_->jobs().busy()) return;
  const fs::path own = CalibrationDir() / "calibration.json", now = workbench_->calibration_path();
  const bool chosen =
      workbench_->calibration() && now.parent_path().parent_path() != own.parent_path().parent_path();
  std::error_code ec;
  if (!chosen && now != own && fs::exists(own, ec)) workbench_->LoadCalibration(own);
}

void VirtualSession::Place(const QString& scene) {
  if (!is_open()) return;
  workbench_->device().Run<bool>(
      tr("Laying something before the device"),
      [scene = scene.toStdString()](Device& device, const Context&) -> Result<bool> {
        if (!device.bench) return UsageError("this device is not virtual");
        DORSUM_RETURN_IF_ERROR(device.bench->PlaceNamed(scene));
        return true;
      },
      [self = QPointer<VirtualSession>(this)](const Result<bool>& placed) {
        if (!self) return;
        emit self->Placed();
        if (!placed.ok()) self->workbench_->Fail(placed.error());
      });
}

void VirtualSession::Calibrate() {
  workbench_->device().Run<fs::path>(
      tr("Calibrating the virtual device"),
      [dir = CalibrationDir()](Device& device, const Context& context) {
        return CalibrateVirtualDevice(device, dir, context);
      },
      [self = QPointer<VirtualSession>(this)](const Result<fs::path>& file) {
        if (!self) return;
        if (!file.ok()) return emit self->Failed(file.error());
        emit self->Calibrated(*file);
      });
}

}  // namespace dorsum
