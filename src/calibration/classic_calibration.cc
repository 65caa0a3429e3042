// SPDX-License-Identifier: Apache-2.0
#include "calibration/classic_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "captures/names.h"

namespace dorsum {
namespace {

// World positions (mm, at y = 0) of the straight lines found on the backplane at the Further distance.
std::vector<double> WorldPositions(const Camera& camera, const PlaneStripes& stripes) {
  std::vector<double> xs;
  for (const double x : stripes.x_mm) {
    // The board of this laser lay elsewhere than the first one, so its plane coordinates go through the
    // image.
    const Eigen::Vector2d pixel = PixelFromPlane(camera, stripes.rectification, {x, 0.0});
    const Ray ray = CastRay(camera, pixel);
    const auto t = Intersect(ray, Plane{});
    xs.push_back(t ? ray.At(*t).x() : 0.0);
  }
  return xs;
}

Status ObserveAll(const CalibrationSeries& series, const CameraCalibration& camera,
                  const ClassicCalibrationOptions& options, const Context& context,
                  std::vector<LaserCalibration>* lasers) {
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("stripes on two planes", 0.0);
  Context inner = context;
  inner.progress = nullptr;
  if (context.sink != nullptr) inner.threads = 1;  // a sink is called from one thread
  std::array<cv::Mat, 2> dark;                     // further, closer
  std::vector<Status> status(2 * lasers->size());
  ParallelFor(inner, 0, 2, [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    Result<cv::Mat> image = series.Read(LaserBgName(i == 0 ? Distance::kFurther : Distance::kCloser));
    if (image.ok()) {
      dark[k] = std::move(*image);
    } else {
      status[k] = image.error();
    }
  });
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  ParallelFor(inner, 0, static_cast<std::int64_t>(status.size()), [&](std::int64_t i) {
    LaserCalibration& laser = (*lasers)[static_cast<std::size_t>(i / 2)];
    const Distance distance = i % 2 == 0 ? Distance::kFurther : Distance::kCloser;
    if (context.IsCancelled()) return;
    const auto known = camera.corners_of.find(LaserChessName(laser.laser, distance));
    Result<PlaneStripes> seen = ObserveStripes(
        series, camera.camera, laser.laser, distance, options.spacing, inner,
        known == camera.corners_of.end() ? nullptr : &known->second, dark[static_cast<std::size_t>(i % 2)]);
    if (!seen.ok()) {
      status[static_cast<std::size_t>(i)] = seen.error();
    } else {
      (i % 2 == 0 ? laser.further : laser.closer) = std::move(*seen);
    }
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  for (LaserCalibration& laser : *lasers) {
    DORSUM_ASSIGN_OR_RETURN(laser.grating,
                            EstimateGratingHeight(laser.further, laser.closer,
                                                  series.setup.calibration_object_height_mm, laser.laser));
  }
  return {};
}

// The stripe closest to the first estimate is the central one (§3.2, "Laser central stripes").
void FindCentralStripes(const Camera& camera, const std::vector<double>& drawn, ClassicCalibration* out) {
  std::map<int, double> brightest;
  for (const LaserCalibration& laser : out->lasers) {
    brightest[laser.laser] =
        WorldPositions(camera, laser.further)[static_cast<std::size_t>(laser.further.central)];
  }
  const std::map<int, double> estimates = AssignFirstEstimates(drawn, brightest);
  if (estimates.empty()) {
    out->warnings.push_back("laserFirstEstimates shows " + std::to_string(drawn.size()) + " lines for " +
                            std::to_string(out->lasers.size()) +
                            " lasers; the brightest stripe of each laser is taken as its central one");
  }
  for (LaserCalibration& laser : out->lasers) {
    laser.first_estimate_mm = estimates.empty() ? brightest[laser.laser] : estimates.at(laser.laser);
    const std::vector<double> xs = WorldPositions(camera, laser.further);
    const auto nearest = std::min_element(xs.begin(), xs.end(), [&](double a, double b) {
      return std::abs(a - laser.first_estimate_mm) < std::abs(b - laser.first_estimate_mm);
    });
    laser.central_x_mm = *nearest;
    const auto index = static_cast<int>(nearest - xs.begin());
    if (index != laser.further.central) {
      out->warnings.push_back("laser " + std::to_string(laser.laser) +
                              ": the brightest stripe is not the one nearest to "
                              "its drawn line; the drawn line decides");
    }
  }
}

Status ModelBackgrounds(const CalibrationSeries& series, const BackgroundModelOptions& options,
                        const Context& context, ClassicCalibration* out) {
  std::vector<Status> status(out->lasers.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(out->lasers.size()), [&](std::int64_t i) {
    LaserCalibration& laser = out->lasers[static_cast<std::size_t>(i)];
    Status& mine = status[static_cast<std::size_t>(i)];
    const Result<cv::Mat> image = series.Read(StripesBgName(laser.laser));
    if (!image.ok()) {
      mine = image.error();
      return;
    }
    Context quiet = context;
    quiet.sink = nullptr;
    Result<BackgroundModel> model =
        ModelBackground(*image, laser.laser, out->camera.camera, laser.central_x_mm,
                        WorldPositions(out->camera.camera, laser.further), options, quiet);
    if (!model.ok()) {
      mine = model.error();
      return;
    }
    laser.background = std::move(*model);
  });
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  return {};
}

const BackgroundLine* CentralLine(const LaserCalibration& laser) {
  for (const BackgroundLine& line : laser.background.lines) {
    if (line.order == 0) return &line;
  }
  return nullptr;
}

void Judge(double calibration_height_mm, LaserCalibration* laser) {
  double bow = 0.0;
  for (const BackgroundLine& line : laser->background.lines) bow = std::max(bow, line.rms_mm);
  const GratingHeight& g = laser->grating;
  laser->report.part = "laser " + std::to_string(laser->laser);
  laser->report.figures = {
      {"grating height", g.height_mm, "mm"},
      {"stripe spacing on the backplane", g.spacing_further_mm, "mm"},
      {"stripe spacing on the calibration object", g.spacing_closer_mm, "mm"},
      {"central stripe", laser->central_x_mm, "mm"},
      {"scale on the backplane", laser->further.rectification.px_per_mm, "px/mm"},
      {"scale on the calibration object", laser->closer.rectification.px_per_mm, "px/mm"},
      {"homography residual", laser->further.rectification.rms_mm, "mm"},
      {"stripes on the backplane", static_cast<double>(laser->background.lines.size()), ""},
      {"largest bow that a line leaves out", bow, "mm"}};
  laser->report.verdict = "all stripes are counted and the spacings fit one grating height";
  if (g.height_mm < 2.0 * calibration_height_mm || g.height_mm > 100.0 * calibration_height_mm) {
    laser->report.grade = Grade::kBad;
    laser->report.verdict = "the grating height makes no sense; is calibration_object_height_mm right?";
  } else if (g.to_order - g.from_order < 5) {
    laser->report.grade = Grade::kDoubtful;
    laser->report.verdict =
        "few stripes are seen at both distances; the exposure is too short for the outer orders";
  }
}

// Everything after the camera. `align` turns the world about the board's centre to the reference laser's
// central stripe (DESIGN §2).
Result<ClassicCalibration> CalibrateLasers(const CalibrationSeries& series, const CameraCalibration& camera,
                                           bool align, const ClassicCalibrationOptions& options,
                                           const Context& context, std::optional<DrawnLines> drawn) {
  ClassicCalibration out;
  out.camera = camera;
  for (const int k : series.lasers) out.lasers.emplace_back().laser = k;
  DORSUM_RETURN_IF_ERROR(ObserveAll(series, out.camera, options, context, &out.lasers));
  if (!drawn) {
    DORSUM_ASSIGN_OR_RETURN(drawn, FindDrawnLines(series, options.first_estimates, context));
  }

  // Two passes: the first finds the direction of the central stripe; the second works in that world.
  for (int pass = align ? 0 : 1; pass < 2; ++pass) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    context.Report("background stripes", 0.5 * pass);
    out.warnings = out.camera.warnings;
    FindCentralStripes(out.camera.camera, PlacesOfLines(*drawn, out.camera.camera), &out);
    DORSUM_RETURN_IF_ERROR(ModelBackgrounds(series, options.background, context, &out));
    const auto one =
        std::find_if(out.lasers.begin(), out.lasers.end(), [](const auto& l) { return l.laser == 1; });
    const LaserCalibration& reference = one == out.lasers.end() ? out.lasers.front() : *one;
    const BackgroundLine* central = CentralLine(reference);
    if (central == nullptr) {
      return BadInput("the central stripe of laser " + std::to_string(reference.laser) +
                      " is not seen in stripesBg" + std::to_string(reference.laser) + "; capture it again");
    }
    // The stripe runs along (slope, 1): turning the axes by -atan(slope) makes it the new y.
    if (pass == 0)
      out.camera.camera = MoveWorld(out.camera.camera, Eigen::Vector3d::Zero(), -std::atan(central->slope));
  }
  out.device.camera = out.camera.camera;
  for (LaserCalibration& laser : out.lasers) {
    if (const BackgroundLine* central = CentralLine(laser)) laser.central_x_mm = central->at;
    LaserGeometry geometry;
    geometry.laser = laser.laser;
    geometry.grating = {laser.central_x_mm, 0.0, laser.grating.height_mm};
    geometry.planes = PlanesThroughGrating(geometry.grating, laser.background.lines);
    geometry.min_order = geometry.planes.front().order;
    geometry.max_order = geometry.planes.back().order;
    geometry.reference = laser.background.reference;
    out.device.lasers.push_back(geometry);
    Judge(series.setup.calibration_object_height_mm, &laser);
  }
  return out;
}

}  // namespace

Result<ClassicCalibration> CalibrateClassic(const CalibrationSeries& series,
                                            const ClassicCalibrationOptions& options,
                                            const Context& context) {
  context.Report("chessboards", 0.0);
  DORSUM_ASSIGN_OR_RETURN(const CameraCalibration camera, CalibrateCamera(series, options.camera, context));
  return CalibrateLasers(series, camera, true, options, context, {});
}

Result<ClassicCalibration> CalibrateClassicLasers(const CalibrationSeries& series,
                                                  const CameraCalibration& camera,
                                                  const ClassicCalibrationOptions& options,
                                                  const Context& context, std::optional<DrawnLines> drawn) {
  return CalibrateLasers(series, camera, false, options, context, std::move(drawn));
}

}  // namespace dorsum
