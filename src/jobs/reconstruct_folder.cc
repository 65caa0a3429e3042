// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_folder.h"

#include <algorithm>
#include <optional>

#include "base/files.h"
#include "base/parallel.h"
#include "jobs/stage_folder.h"

namespace dorsum {

namespace {

// A calibration's file, read, and ready as far as a capture can be loaded for it.
struct ReadFileOfCalibration {
  std::string bytes;
  Calibration calibration;

  std::vector<int> Lasers() const {
    std::vector<int> lasers;
    lasers.reserve(calibration.device.lasers.size());
    for (const LaserGeometry& laser : calibration.device.lasers) lasers.push_back(laser.laser);
    return lasers;
  }
};

Result<ReadFileOfCalibration> ReadWhole(const std::filesystem::path& path) {
  ReadFileOfCalibration out;
  DORSUM_ASSIGN_OR_RETURN(out.bytes, ReadFile(path, std::size_t{256} << 20));
  DORSUM_ASSIGN_OR_RETURN(out.calibration, ReadCalibration(path));
  return out;
}

Result<LoadedCalibration> Prepare(ReadFileOfCalibration read, const std::filesystem::path& path) {
  LoadedCalibration out;
  out.lasers = read.Lasers();
  out.sha256 = Sha256Hex(read.bytes);
  DORSUM_ASSIGN_OR_RETURN(out.ready, PrepareCalibration(std::move(read.calibration), path.string()));
  return out;
}

}  // namespace

Result<LoadedCalibration> LoadCalibration(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(ReadFileOfCalibration read, ReadWhole(path));
  return Prepare(std::move(read), path);
}

Channels StripeChannels(const ReconstructRequest& request) {
  const bool shown = request.report || request.stages;
  return !shown && ResolveStages(request.options).stripes == "ridge" ? Channels::kGreen : Channels::kBgr;
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
  DORSUM_ASSIGN_OR_RETURN(ReadFileOfCalibration read, ReadWhole(request.calibration_path));
  const std::vector<int> lasers = read.Lasers();
  std::optional<Result<LoadedCalibration>> calibration;
  std::optional<Result<CaptureImages>> capture;
  ParallelFor(context, 0, 2, [&](std::int64_t part) {
    if (part == 0) {
      calibration = Prepare(std::move(read), request.calibration_path);
    } else {
      capture = LoadCapture(request.capture_dir, {}, lasers, context, StripeChannels(request));
    }
  });
  if (!calibration->ok()) return calibration->error();
  if (!capture->ok()) return capture->error();
  return ReconstructLoaded(**capture, request, **calibration, context);
}

}  // namespace dorsum
