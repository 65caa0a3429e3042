// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_folder.h"

#include <algorithm>

#include "base/files.h"
#include "jobs/stage_folder.h"

namespace dorsum {

Result<LoadedCalibration> LoadCalibration(const std::filesystem::path& path) {
  LoadedCalibration out;
  DORSUM_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path, std::size_t{256} << 20));
  out.sha256 = Sha256Hex(bytes);
  DORSUM_ASSIGN_OR_RETURN(Calibration calibration, ReadCalibration(path));
  DORSUM_ASSIGN_OR_RETURN(out.ready, PrepareCalibration(std::move(calibration), path.string()));
  for (const LaserGeometry& laser : out.ready.calibration.device.lasers) out.lasers.push_back(laser.laser);
  return out;
}

Result<ReconstructSummary> ReconstructLoaded(const CaptureImages& capture, const ReconstructRequest& request,
                                             const LoadedCalibration& calibration, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(StagedFolder staged, StagedFolder::Create(request.out_dir));
  StageFolder stages(staged.path() / kStageFolder);
  Context inner = context;
  if (request.stages) inner.sink = &stages;
  DORSUM_ASSIGN_OR_RETURN(const Reconstruction result,
                          Reconstruct(capture, calibration.ready, request.options, inner));
  if (!stages.status().ok()) return stages.status().error();
  DORSUM_RETURN_IF_ERROR(WriteReconstruction(staged.path(), request, result, capture, calibration, context));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());

  ReconstructSummary summary;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(staged.path())) {
    if (!entry.is_regular_file()) continue;
    summary.files.push_back(std::filesystem::relative(entry.path(), staged.path()).generic_string());
  }
  std::sort(summary.files.begin(), summary.files.end());
  DORSUM_RETURN_IF_ERROR(staged.Commit());
  RemoveEarlierFiles(request.out_dir, summary.files);
  summary.points = result.points.size();
  summary.faces = result.mesh.faces.size();
  summary.warnings = result.warnings;
  summary.points_by_laser.resize(static_cast<std::size_t>(calibration.lasers.back()) + 1, 0);
  for (const SurfacePoint& p : result.points) ++summary.points_by_laser[p.laser];
  return summary;
}

Result<ReconstructSummary> ReconstructFolder(const ReconstructRequest& request, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const LoadedCalibration calibration, LoadCalibration(request.calibration_path));
  DORSUM_ASSIGN_OR_RETURN(const CaptureImages capture,
                          LoadCapture(request.capture_dir, {}, calibration.lasers));
  return ReconstructLoaded(capture, request, calibration, context);
}

}  // namespace dorsum
