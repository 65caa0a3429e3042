// SPDX-License-Identifier: Apache-2.0
#include "studio/workbench.h"

#include <chrono>
#include <utility>

#include "calibration/calibration_file.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

Result<std::shared_ptr<const Scan>> ReadScan(const fs::path& path,
                                             const std::shared_ptr<const ReadyCalibration>& calibration,
                                             const Context& context) {
  std::error_code ec;
  if (!fs::is_directory(path, ec)) {
    if (path.extension() == ".ply") return ReadSurface(path);
    return BadInput(path.string() + " is neither a capture folder nor a PLY file; drop one of those");
  }
  if (!calibration) {
    return BadInput("a capture needs the calibration of its device; open a calibration.json first");
  }
  const Camera& camera = calibration->calibration.device.camera;
  std::vector<int> lasers;
  for (const LaserGeometry& laser : calibration->calibration.device.lasers) lasers.push_back(laser.laser);
  DORSUM_ASSIGN_OR_RETURN(CaptureImages capture, LoadCapture(path, {camera.width, camera.height}, lasers));
  return MakeScan(path.filename().string(), path, std::move(capture), calibration, {}, context);
}

}  // namespace

Result<std::shared_ptr<const Scan>> ReadSurface(const fs::path& path) {
  auto scan = std::make_shared<Scan>();
  scan->name = path.filename().string();
  Result<TriangleMesh> mesh = ReadMeshPly(path);
  if (mesh.ok() && !mesh->faces.empty()) {
    scan->surface.mesh = std::move(mesh).value();
    return std::shared_ptr<const Scan>(std::move(scan));
  }
  Result<SurfacePoints> points = ReadPointsPly(path);
  if (!points.ok()) return mesh.ok() ? points.error() : mesh.error();
  scan->surface.points = std::move(points).value();
  return std::shared_ptr<const Scan>(std::move(scan));
}

Result<std::shared_ptr<const Scan>> MakeScan(std::string name, fs::path folder, CaptureImages capture,
                                             std::shared_ptr<const ReadyCalibration> calibration,
                                             const ReconstructOptions& options, const Context& context) {
  auto scan = std::make_shared<Scan>();
  const auto begin = std::chrono::steady_clock::now();
  DORSUM_ASSIGN_OR_RETURN(scan->surface, Reconstruct(capture, *calibration, options, context));
  scan->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  scan->name = std::move(name);
  scan->folder = std::move(folder);
  scan->capture = std::move(capture);
  scan->calibration = std::move(calibration);
  return std::shared_ptr<const Scan>(std::move(scan));
}

void Workbench::SetScan(std::shared_ptr<const Scan> scan) {
  scan_ = std::move(scan);
  emit ScanChanged();
}

void Workbench::LoadCalibration(const fs::path& path) {
  if (jobs_.busy()) return emit Failed(UsageError("something else is being done; wait for it, or cancel it"));
  jobs_.Run<std::shared_ptr<const ReadyCalibration>>(
      tr("Reading the calibration"),
      [path](const Context&) -> Result<std::shared_ptr<const ReadyCalibration>> {
        DORSUM_ASSIGN_OR_RETURN(Calibration calibration, ReadCalibration(path));
        DORSUM_ASSIGN_OR_RETURN(ReadyCalibration ready,
                                PrepareCalibration(std::move(calibration), path.string()));
        return std::make_shared<const ReadyCalibration>(std::move(ready));
      },
      [this, path](Result<std::shared_ptr<const ReadyCalibration>> ready) {
        if (!ready.ok()) return emit Failed(ready.error());
        calibration_ = *ready;
        calibration_path_ = path;
        emit CalibrationChanged();
      });
}

void Workbench::OpenPath(const fs::path& path) {
  if (path.extension() == ".json") return LoadCalibration(path);
  if (jobs_.busy()) return emit Failed(UsageError("something else is being done; wait for it, or cancel it"));
  jobs_.Run<std::shared_ptr<const Scan>>(
      tr("Opening %1").arg(QString::fromStdString(path.filename().string())),
      [path, calibration = calibration_](const Context& context) {
        return ReadScan(path, calibration, context);
      },
      [this](Result<std::shared_ptr<const Scan>> scan) {
        if (!scan.ok()) return emit Failed(scan.error());
        SetScan(*scan);
      });
}

}  // namespace dorsum
