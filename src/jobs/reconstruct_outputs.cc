// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_outputs.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "base/files.h"
#include "base/parallel.h"
#include "base/version.h"
#include "captures/png_image.h"
#include "jobs/reconstruct_report.h"
#include "surface/height_file.h"
#include "surface/mesh_export.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

Json Stages(const ReconstructOptions& asked) {
  const ReconstructOptions o = ResolveStages(asked);
  return {{"mask", o.mask},     {"stripes", o.stripes}, {"indexing", o.indexing},
          {"sheets", o.sheets}, {"shading", o.shading}, {"correction", o.correction},
          {"fusion", o.fusion}};
}

// report.json: what was made from what, how, and how much of it.
Json ReportJson(const ReconstructRequest& request, const Reconstruction& result, const Json& recipe) {
  Json lasers = Json::array();
  for (const IndexingDiagnostics& d : result.stripes.diagnostics) {
    const auto points = std::count_if(result.points.begin(), result.points.end(),
                                      [&](const SurfacePoint& p) { return p.laser == d.laser; });
    lasers.push_back({{"laser", d.laser},
                      {"points", points},
                      {"segments", d.segments},
                      {"segments_without_order", d.left_out},
                      {"index_corrections", d.corrections}});
  }
  Json offsets = Json::array();
  for (const LaserOffset& o : result.offsets) {
    offsets.push_back({{"laser", o.laser}, {"offset_mm", o.mean_mm}, {"sd_mm", o.sd_mm}});
  }
  Json shifts = Json::array();
  for (const LaserConsistency& c : result.consistency) {
    if (c.samples == 0) continue;
    shifts.push_back({{"laser", c.laser},
                      {"shift_mm", {c.shift_mm.x(), c.shift_mm.y(), c.shift_mm.z()}},
                      {"sd_mm", {c.shift_sd_mm.x(), c.shift_sd_mm.y(), c.shift_sd_mm.z()}},
                      {"significance", c.shift_significance}});
  }
  Json report = {{"schema", "dorsum/report"},
                 {"version", 1},
                 {"capture", request.capture_dir.filename().string()},
                 {"points", result.points.size()},
                 {"points_without_order", result.without_order},
                 {"points_without_sheet", result.without_sheet},
                 {"points_contradicted", result.contradicted},
                 {"triangles", result.mesh.faces.size()},
                 {"crossings_left_out", result.height_field.left_out},
                 {"mask_threshold", result.mask.threshold},
                 {"mask_area_share", result.mask.area_share},
                 {"lasers", lasers},
                 {"height_offsets", offsets},
                 {"shifts_against_other_lasers", shifts},
                 {"warnings", result.warnings}};
  report.update(recipe);
  return report;
}

}  // namespace

Json RecipeOf(const ReconstructRequest& request, const LoadedCalibration& calibration) {
  ReconstructOptions options = request.options;
  Json tuning = Json::object();
  const OptionTable table = DescribeReconstructOptions(&options);
  for (const OptionSpec& spec : table.specs()) tuning[spec.name] = OptionTable::ValueText(spec);
  return {{"program", kVersion},
          {"calibration",
           {{"file", request.calibration_path.filename().string()},
            {"sha256", calibration.sha256},
            {"method", calibration.ready.calibration.method}}},
          {"lasers_asked", request.options.lasers},
          {"stages", Stages(request.options)},
          {"options", tuning}};
}

Status WriteReconstruction(const std::filesystem::path& dir, const ReconstructRequest& request,
                           const Reconstruction& result, const CaptureImages& capture,
                           const LoadedCalibration& calibration, const Context& context) {
  std::vector<std::function<Status()>> files;  // what takes longest first
  for (const std::string& format : request.mesh_formats) {
    if (result.mesh.faces.empty() && format != "ply") continue;  // the warning about the empty mesh says why
    files.emplace_back([&] { return ExportMesh(dir, "surface", format, result.mesh); });
  }
  files.emplace_back([&] { return WriteHeightField(dir, result.height_field); });
  files.emplace_back([&] { return WriteFile(dir / "mask.png", EncodePng(result.mask.mask, 1)); });
  files.emplace_back([&] { return WritePointsPly(dir / "points.ply", result.points); });
  files.emplace_back([&] {
    return WriteJson(dir / kReportJson, ReportJson(request, result, RecipeOf(request, calibration)));
  });
  std::vector<Status> status(files.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(files.size()), [&](std::int64_t i) {
    status[static_cast<std::size_t>(i)] = files[static_cast<std::size_t>(i)]();
  });
  for (const Status& one : status) DORSUM_RETURN_IF_ERROR(one);
  if (!request.report) return {};
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("report", 0.9);
  const ReportPages pages =
      MakeReconstructionReport(CollectReportData(request, result, capture, calibration.ready), context);
  DORSUM_RETURN_IF_ERROR(WriteFile(dir / "report.html", pages.html));
  return WriteFile(dir / "overview.png", pages.overview_png);
}

// What an earlier run with other options wrote to the same folder belongs to another surface.
void RemoveEarlierFiles(const std::filesystem::path& dir, const std::vector<std::string>& written) {
  std::vector<std::string> ours = {"height.tiff", "height.json", "report.html", "overview.png"};
  for (const std::string& format : MeshFormats()) ours.push_back("surface." + format);
  const std::filesystem::path stages = dir / kStageFolder;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(stages, ignored)) {
    if (entry.path().extension() == ".png")
      ours.push_back(kStageFolder + ("/" + entry.path().filename().string()));
  }
  for (const std::string& name : ours) {
    if (std::find(written.begin(), written.end(), name) == written.end())
      std::filesystem::remove(dir / name, ignored);
  }
  if (std::filesystem::is_directory(stages, ignored) && std::filesystem::is_empty(stages, ignored))
    std::filesystem::remove(stages, ignored);
}

}  // namespace dorsum
