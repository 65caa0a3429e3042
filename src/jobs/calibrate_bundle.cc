// SPDX-License-Identifier: Apache-2.0
#include "jobs/calibrate_bundle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/median.h"
#include "base/parallel.h"
#include "captures/capture.h"
#include "captures/image_file.h"
#include "captures/names.h"

namespace dorsum {
namespace {

// The classic chain for all lasers together, or, where one of them defeats it, for each alone.
ClassicCalibration ClassicBeside(const CalibrationSeries& series, const CameraCalibration& camera,
                                 const std::optional<DrawnLines>& drawn, const CalibrateOptions& options,
                                 const Context& context, std::vector<std::string>* warnings) {
  Result<ClassicCalibration> all = CalibrateClassicLasers(series, camera, options.classic, context, drawn);
  if (all.ok()) return std::move(*all);
  ClassicCalibration out;
  out.camera = camera;
  out.device.camera = camera.camera;
  for (const int laser : series.lasers) {
    if (context.IsCancelled()) break;
    CalibrationSeries one = series;
    one.lasers = {laser};
    Result<ClassicCalibration> alone = CalibrateClassicLasers(one, camera, options.classic, context, drawn);
    if (!alone.ok()) {
      warnings->push_back("the document's method finds no sheets for laser " + std::to_string(laser) + " (" +
                          alone.error().message + "); only cone sheets are there for it");
      continue;
    }
    out.lasers.push_back(std::move(alone->lasers.front()));
    out.device.lasers.push_back(std::move(alone->device.lasers.front()));
  }
  return out;
}

// The classic chain counts from its own central stripe; here both must count from the same one.
int OrderShift(const LaserGeometry& classic, const DiffractedFan& fan) {
  std::vector<double> shifts;
  for (const PlaneSheet& sheet : classic.planes) {
    const double slope = sheet.plane.normal.x();
    if (std::abs(slope) < 1e-6) continue;
    const auto at = Locate(fan, {sheet.plane.offset / slope, 0.0, 0.0});
    if (at) shifts.push_back(at->Order(fan) - sheet.order);
  }
  return static_cast<int>(std::lround(Median(std::move(shifts))));
}

void AddClassicSheets(const LaserGeometry& classic, LaserGeometry* laser) {
  const int shift = OrderShift(classic, *laser->fan);
  laser->grating = classic.grating;
  laser->planes = classic.planes;
  for (PlaneSheet& sheet : laser->planes) sheet.order += shift;
  laser->reference = classic.reference;
  for (ReferenceStripe& r : laser->reference) r.order += shift;
}

// Pictures that a part of the method or nothing looks at; a bad one is refused all the same.
Status CheckOthers(const CalibrationSeries& series, const Context& context,
                   std::vector<std::string>* warnings) {
  std::vector<std::string> names = {LaserBgName(Distance::kFurther), LaserBgName(Distance::kCloser)};
  const std::size_t first_lit = names.size();  // those from here on must show something
  names.emplace_back(kFirstEstimatesName);
  for (const double height : series.box_heights_mm) {
    names.push_back(std::string(kHeightsFolder) + "/" + HeightFolderName(height) + "/" + kBgHandName);
    for (const int laser : series.lasers) {
      if (!FindImage(series.BoxDir(height), StripesHandName(laser)))
        warnings->push_back(MissingStripes(series.BoxDir(height), laser));
    }
  }
  std::vector<Status> status(names.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(names.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    const Result<cv::Mat> image = series.Read(names[k], Channels::kGreen);
    status[k] = !image.ok()      ? Status(image.error())
                : k >= first_lit ? CheckExposure(*image, (series.dir / names[k]).string())
                                 : Status();
  });
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  return {};
}

}  // namespace

Status CalibrateByBundle(const CalibrationSeries& series, const CalibrateOptions& options,
                         const Context& context, CalibrationRun* run) {
  DORSUM_RETURN_IF_ERROR(CheckOthers(series, context, &run->calibration.warnings));
  DORSUM_ASSIGN_OR_RETURN(BundleCalibration bundle,
                          CalibrateBundle(series, options.classic.camera, options.bundle, context));
  Calibration& c = run->calibration;
  CameraCalibration refined = bundle.start;
  refined.camera = bundle.device.camera;
  refined.view_rms_px = bundle.view_rms_px;
  for (const BoardView& board : bundle.data.boards) {
    std::vector<cv::Point2f>& corners = refined.corners_of[board.name];
    for (const Eigen::Vector2d& at : board.corners)
      corners.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()));
  }
  c.warnings.insert(c.warnings.end(), bundle.start.warnings.begin(), bundle.start.warnings.end());
  c.warnings.insert(c.warnings.end(), bundle.warnings.begin(), bundle.warnings.end());
  run->classic = ClassicBeside(series, refined, bundle.drawn, options, context, &c.warnings);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  c.device = bundle.device;
  for (LaserGeometry& laser : c.device.lasers) {
    if (const LaserGeometry* classic = run->classic.device.FindLaser(laser.laser))
      AddClassicSheets(*classic, &laser);
  }
  c.parts = bundle.parts;
  run->bundle = std::move(bundle);
  return {};
}

}  // namespace dorsum
