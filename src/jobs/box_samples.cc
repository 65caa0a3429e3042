// SPDX-License-Identifier: Apache-2.0
#include "jobs/box_samples.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "calibration/sheet_pictures.h"
#include "captures/capture.h"

namespace dorsum {
namespace {

// Points of one box, reconstructed by the document's way without correction, on the box's mask shrunk as
// evaluation does.
Result<SamplesByLaser> SampleBox(const CaptureImages& capture, double height_mm,
                                 const ReadyCalibration& ready, const CalibrateOptions& options,
                                 const Context& context) {
  ReconstructOptions reconstruct;
  reconstruct.method = "classic";
  reconstruct.correction = "none";
  DORSUM_ASSIGN_OR_RETURN(const Reconstruction box, ReconstructPoints(capture, ready, reconstruct, context));
  cv::Mat inner;
  cv::erode(box.mask.mask, inner, cv::getStructuringElement(cv::MORPH_RECT, {7, 7}));
  SamplesByLaser all, some;
  for (const SurfacePoint& p : box.points) {
    const auto u = static_cast<int>(std::lround(p.u)), v = static_cast<int>(std::lround(p.v));
    if (u < 0 || v < 0 || u >= inner.cols || v >= inner.rows || inner.at<std::uint8_t>(v, u) == 0) continue;
    all[p.laser].push_back({p.position.x(), p.position.z(), height_mm});
  }
  for (auto& [laser, list] : all) {
    const std::size_t step = list.size() / options.samples_per_laser_and_box + 1;
    for (std::size_t k = 0; k < list.size(); k += step) some[laser].push_back(list[k]);
  }
  return some;
}

}  // namespace

Result<SamplesByLaser> SampleBoxes(const CalibrationSeries& series, const ReadyCalibration& ready,
                                   const CalibrateOptions& options, const Context& context,
                                   std::vector<std::string>* warnings) {
  struct Box {
    std::vector<std::string> warnings;
    SamplesByLaser samples;
    Status unread, unmade;
  };
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("boxes", 0.9);
  Context inner = context;
  inner.progress = nullptr;
  if (context.sink != nullptr) inner.threads = 1;  // a sink is called from one thread
  std::vector<Box> boxes(series.box_heights_mm.size());
  ParallelFor(inner, 0, static_cast<std::int64_t>(boxes.size()), [&](std::int64_t i) {
    Box& box = boxes[static_cast<std::size_t>(i)];
    const double height = series.box_heights_mm[static_cast<std::size_t>(i)];
    if (context.IsCancelled()) return;
    Result<CaptureImages> capture =
        LoadCapture(series.BoxDir(height), {series.setup.width, series.setup.height}, series.lasers);
    if (!capture.ok()) {
      box.unread = capture.error();
      return;
    }
    box.warnings = capture->warnings;
    Result<SamplesByLaser> samples = SampleBox(*capture, height, ready, options, inner);
    if (samples.ok()) {
      box.samples = std::move(*samples);
    } else {
      box.unmade = samples.error();
    }
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  SamplesByLaser samples;
  for (const Box& box : boxes) {
    DORSUM_RETURN_IF_ERROR(box.unread);
    warnings->insert(warnings->end(), box.warnings.begin(), box.warnings.end());
    DORSUM_RETURN_IF_ERROR(box.unmade);
    for (const auto& [laser, list] : box.samples)
      samples[laser].insert(samples[laser].end(), list.begin(), list.end());
  }
  return samples;
}

SamplesByLaser SampleBundle(const BundleCalibration& bundle, const DeviceGeometry& device) {
  SamplesByLaser samples;
  for (const SheetPoint& p : bundle.data.points) {
    if (p.plane < kFirstBoxPlane) continue;
    const LaserGeometry& laser = device.lasers[static_cast<std::size_t>(p.laser)];
    const auto at = IntersectSheet(CastRay(device.camera, {p.u, p.v}), laser, SheetModel::kPlane, p.order);
    const double height = bundle.solution.state.planes[static_cast<std::size_t>(p.plane)][0];
    if (at && at->allFinite()) samples[laser.laser].push_back({at->x(), at->z(), height});
  }
  return samples;
}

}  // namespace dorsum
