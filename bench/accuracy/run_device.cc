// SPDX-License-Identifier: Apache-2.0
#include "accuracy/run_device.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <opencv2/imgcodecs.hpp>

#include "accuracy/budget.h"
#include "accuracy/scene_kind.h"
#include "accuracy/true_device.h"
#include "jobs/calibrate.h"
#include "jobs/reconstruct.h"
#include "simulator/sheet_error.h"
#include "surface/ply.h"

namespace dorsum::accuracy {
namespace {

namespace fs = std::filesystem;

bool IsRefusal(const Error& error) {
  return error.code != ErrorCode::kCancelled && error.code != ErrorCode::kInternal;
}

// §5.1 on boxes and the radius of round things, by the product's own evaluation.
Status Evaluate51(const fs::path& out, CaptureResult* result, const Context& context) {
  const SceneInfo scene = DescribeScene(result->name);
  EvaluateRequest request;
  request.out_dirs = {out};
  if (scene.kind == SceneKind::kBox) {
    request.plane_height_mm = scene.size_mm;
  } else if (scene.kind == SceneKind::kSphere || scene.kind == SceneKind::kCylinder) {
    request.fit = scene.kind == SceneKind::kSphere ? Shape::kSphere : Shape::kCylinder;
  } else {
    return {};
  }
  DORSUM_ASSIGN_OR_RETURN(const Evaluation evaluation, Evaluate(request, context));
  const CaptureErrors& errors = evaluation.captures.front();
  if (errors.shape) {
    result->figures["radius_error"] = std::abs(errors.shape->radius_mm - scene.size_mm);
  } else {
    result->models = errors.models;
  }
  return {};
}

// Height errors that the calibrated cones alone cause; none where there are no cones.
Figures SheetFigures(const DeviceGeometry& calibrated, const DeviceGeometry& true_device) {
  std::vector<DiffractedFan> fans;
  std::vector<int> orders;
  for (const LaserGeometry& laser : true_device.lasers) {
    fans.push_back(*laser.fan);
    orders.push_back(laser.max_order);
  }
  Figures figures;
  for (const LaserGeometry& laser : calibrated.lasers) {
    if (!laser.fan) return {};
  }
  for (const SheetError& e : MeasureSheetError(calibrated, true_device.camera, fans, orders)) {
    figures["sheet_rms"] = std::max(figures["sheet_rms"], e.rms_mm);
    figures["sheet_worst"] = std::max(figures["sheet_worst"], e.worst_mm);
    figures["sheet_rms_laser" + std::to_string(e.laser)] = e.rms_mm;
  }
  return figures;
}

struct Calibrated {
  fs::path path;
  std::string refused;
  DeviceGeometry device;
  Figures figures;
};

Result<Calibrated> Calibrate(const DeviceData& data, const DeviceGeometry& true_device,
                             const std::string& method, const Context& context) {
  CalibrateOptions options;
  options.method = method;
  Calibrated out{data.out_dir / ("calibration_" + method + ".json"), "", {}, {}};
  const Result<CalibrationRun> run = CalibrateFolder(data.calibration_dir, out.path, options, context);
  if (!run.ok()) {
    if (!IsRefusal(run.error())) return run.error();
    out.refused = run.error().message;
    return out;
  }
  out.device = run->calibration.device;
  out.figures = SheetFigures(out.device, true_device);
  return out;
}

// What one calibrated way of working makes of one capture.
struct Way {
  const Rung* rung;
  const Calibrated* calibrated;
  fs::path out;
  bool budget;
};

// A sentence of the product without the folder in which this machine keeps the files.
std::string WithoutFolder(std::string sentence, const fs::path& folder) {
  const std::string prefix = folder.string() + "/";
  for (std::size_t at = sentence.find(prefix); at != std::string::npos; at = sentence.find(prefix)) {
    sentence.erase(at, prefix.size());
  }
  return sentence;
}

Result<CaptureResult> RunCapture(const DeviceData::Capture& capture, const Way& way,
                                 const CaptureTruth& truth, const DeviceGeometry& true_device,
                                 const Context& context) {
  CaptureResult result;
  result.name = capture.name;
  const fs::path out = way.out / capture.name;
  const Result<ReconstructSummary> made = ReconstructFolder(
      {capture.capture_dir, way.calibrated->path, out, way.rung->options, {"ply"}, false, false}, context);
  if (!made.ok()) {
    if (!IsRefusal(made.error())) return made.error();
    result.refused = WithoutFolder(made.error().message, capture.capture_dir);
    return result;
  }
  result.warnings = made->warnings;
  DORSUM_ASSIGN_OR_RETURN(const SurfacePoints points, ReadPointsPly(out / "points.ply"));
  DORSUM_ASSIGN_OR_RETURN(const TriangleMesh mesh, ReadMeshPly(out / "surface.ply"));
  const std::optional<PointScore> score = ScorePoints(truth, points);
  if (!score) {
    result.refused = "(too few points on the object to score)";
    return result;
  }
  result.figures = ToFigures(*score, ScoreSurface(truth, mesh, score->alignment));
  const cv::Mat mask = cv::imread((out / "mask.png").string(), cv::IMREAD_GRAYSCALE);
  if (mask.size() == truth.material.size()) {
    const MaskScore of_mask = ScoreMask(truth, mask);
    result.figures["mask_missing"] = of_mask.missing;
    result.figures["mask_beyond"] = of_mask.beyond;
  }
  DORSUM_RETURN_IF_ERROR(Evaluate51(out, &result, context));
  if (way.budget) {
    result.budget =
        ErrorBudget(truth, true_device, way.calibrated->device, way.rung->options, points, context);
  }
  return result;
}

// (5.2): how far the errors of repeated captures differ.
std::vector<RepeatDifference> Repeats(const std::vector<CaptureResult>& captures) {
  std::vector<RepeatDifference> repeats;
  for (std::size_t i = 0; i < captures.size(); ++i) {
    for (std::size_t k = i + 1; k < captures.size(); ++k) {
      if (DescribeScene(captures[i].name).scene != DescribeScene(captures[k].name).scene) continue;
      for (const ModelErrors& a : captures[i].models) {
        for (const ModelErrors& b : captures[k].models) {
          if (a.model != b.model) continue;
          repeats.push_back({captures[i].name, captures[k].name, a.model, std::abs(a.rmse_mm - b.rmse_mm)});
        }
      }
    }
  }
  return repeats;
}

}  // namespace

Result<std::vector<DeviceResult>> RunDevice(const DeviceData& data, const std::vector<Rung>& rungs,
                                            const RunOptions& options, const Context& context) {
  std::error_code error;
  fs::create_directories(data.out_dir, error);
  if (error) return BadInput("cannot write " + data.out_dir.string() + ": " + error.message());
  DORSUM_ASSIGN_OR_RETURN(const DeviceGeometry true_device, ReadTrueDevice(data.device_json));
  std::vector<DeviceResult> results(rungs.size());
  std::map<std::string, Calibrated> by_method;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    results[i].design = data.design;
    results[i].seed = data.seed;
    results[i].rung = rungs[i].name;
    if (!by_method.contains(rungs[i].calibration)) {
      DORSUM_ASSIGN_OR_RETURN(by_method[rungs[i].calibration],
                              Calibrate(data, true_device, rungs[i].calibration, context));
    }
    const Calibrated& calibrated = by_method[rungs[i].calibration];
    results[i].refused = calibrated.refused;
    results[i].figures = calibrated.figures;
  }
  for (const DeviceData::Capture& capture : data.captures) {
    DORSUM_ASSIGN_OR_RETURN(const CaptureTruth truth, ReadCaptureTruth(capture.truth_dir, data.device_json));
    for (std::size_t i = 0; i < rungs.size(); ++i) {
      if (!results[i].refused.empty()) continue;
      DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
      const Rung& rung = rungs[i];
      const bool budget = std::count(options.budget_of.begin(), options.budget_of.end(), rung.name) > 0;
      const Way way{&rung, &by_method[rung.calibration], data.out_dir / FolderName(rung.name), budget};
      DORSUM_ASSIGN_OR_RETURN(CaptureResult one, RunCapture(capture, way, truth, true_device, context));
      if (options.said) {
        const auto z = one.figures.find("z_rmse");
        options.said(data.design + " " + data.seed + ", " + capture.name + ", " + rung.name + ": " +
                     (z == one.figures.end() ? one.refused : std::to_string(z->second) + " mm"));
      }
      results[i].captures.push_back(std::move(one));
    }
  }
  for (DeviceResult& result : results) result.repeats = Repeats(result.captures);
  return results;
}

}  // namespace dorsum::accuracy
