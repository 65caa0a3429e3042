// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct.h"

#include <algorithm>

#include "base/parallel.h"
#include "captures/image_file.h"
#include "imaging/shadow.h"
#include "imaging/stage_sink.h"
#include "surface/height_mesh.h"
#include "surface/triangulation.h"

namespace dorsum {
namespace {

bool IsWanted(const std::vector<int>& lasers, int laser) {
  return lasers.empty() || std::find(lasers.begin(), lasers.end(), laser) != lasers.end();
}

// StripePoints and StripeSegments of all wanted lasers, side by side.
std::vector<LaserStripes> FindStripes(const CaptureImages& capture, const cv::Mat& mask,
                                      const DeviceGeometry& device, const ReconstructOptions& options,
                                      const Context& context) {
  std::vector<int> lasers;
  for (const LaserGeometry& laser : device.lasers) {
    const auto k = static_cast<std::size_t>(laser.laser);
    if (IsWanted(options.lasers, laser.laser) && k < capture.stripes.size() && capture.stripes[k]) {
      lasers.push_back(laser.laser);
    }
  }
  std::vector<LaserStripes> stripes(lasers.size());
  Context inner = context;
  if (context.sink != nullptr) inner.threads = 1;  // a sink is called from one thread
  ParallelFor(inner, 0, static_cast<std::int64_t>(lasers.size()), [&](std::int64_t i) {
    const int laser = lasers[static_cast<std::size_t>(i)];
    const cv::Mat& image = *capture.stripes[static_cast<std::size_t>(laser)];
    const cv::Mat stripe_mask =
        ExtractStripeMask(image, mask, options.stripe_mask, "stripes/" + std::to_string(laser), inner);
    const LaserStripes raw =
        ExtractClassicSegments(stripe_mask, GreenChannel(image), laser, options.segments);
    stripes[static_cast<std::size_t>(i)] = SmoothSegments(raw, options.segments.min_rows, options.smoothing);
  });
  return stripes;
}

// The mask without the shadow that the stripes on the backplane give away; hands out the object's stripes.
std::vector<LaserStripes> SeparateShadow(std::vector<BackplaneSplit> splits, cv::Mat* mask) {
  std::vector<cv::Point> object, backplane;
  std::vector<LaserStripes> stripes;
  for (BackplaneSplit& split : splits) {
    for (const StripePoint& p : split.object.points) object.emplace_back(cvRound(p.u), cvRound(p.v));
    for (const StripePoint& p : split.backplane) backplane.emplace_back(cvRound(p.u), cvRound(p.v));
    stripes.push_back(std::move(split.object));
  }
  *mask = RemoveShadow(*mask, object, backplane);
  return stripes;
}

Status CheckResolution(const CaptureImages& capture, const Camera& camera) {
  if (capture.hand.cols == camera.width && capture.hand.rows == camera.height) return {};
  return BadInput("the calibration is for images of " + std::to_string(camera.width) + "x" +
                  std::to_string(camera.height) + ", but the capture has " +
                  std::to_string(capture.hand.cols) + "x" + std::to_string(capture.hand.rows) +
                  "; use the calibration of this camera and resolution");
}

}  // namespace

Result<ReadyCalibration> PrepareCalibration(Calibration calibration, const std::string& where) {
  ReadyCalibration ready;
  const cv::Size size(calibration.device.camera.width, calibration.device.camera.height);
  DORSUM_ASSIGN_OR_RETURN(ready.background,
                          DecodeImage(calibration.background, where + ": the background image", size));
  ready.calibration = std::move(calibration);
  return ready;
}

Result<Reconstruction> ReconstructPoints(const CaptureImages& capture, const ReadyCalibration& ready,
                                         const ReconstructOptions& options, const Context& context) {
  const DeviceGeometry& device = ready.calibration.device;
  DORSUM_RETURN_IF_ERROR(CheckResolution(capture, device.camera));
  for (const int laser : options.lasers) {
    if (device.FindLaser(laser) == nullptr) {
      return UsageError("--lasers names laser " + std::to_string(laser) +
                        ", which the calibration does not know");
    }
  }
  Reconstruction out;
  out.warnings = capture.warnings;
  context.Report("mask", 0.0);
  DORSUM_ASSIGN_OR_RETURN(out.mask,
                          ExtractHandMask(ready.background, capture.hand, options.hand_mask, context));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("stripes", 0.2);
  const std::vector<LaserStripes> in_mask = FindStripes(capture, out.mask.mask, device, options, context);
  std::vector<LaserStripes> stripes = SeparateShadow(
      SplitBackplane(in_mask, device, options.segments.min_rows, options.backplane), &out.mask.mask);
  Sink(context, "mask/without_shadow", out.mask.mask);
  out.mask.area_share =
      static_cast<double>(cv::countNonZero(out.mask.mask)) / static_cast<double>(out.mask.mask.total());
  if (out.mask.area_share < options.hand_mask.min_area_share) {
    return BadInput(
        "only shadow is seen in bgHand: the object is as bright as the backplane, or it is gone; cover a "
        "white object "
        "with something darker and capture again");
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("indexing", 0.5);
  out.stripes = IndexClassic(std::move(stripes), device, SheetModel::kPlane, options.classic_indexing);
  for (const LaserStripes& one : out.stripes.lasers) {
    if (one.points.empty()) {
      out.warnings.push_back("laser " + std::to_string(one.laser) +
                             " shows no stripe on the object; is it on?");
    }
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("surface", 0.6);
  Triangulation triangulation =
      Triangulate(out.stripes, device,
                  {.sheets = SheetModel::kPlane, .correction = options.correction == "polynomial"}, context);
  out.points = std::move(triangulation.points);
  out.without_order = triangulation.without_order;
  out.without_sheet = triangulation.without_sheet;
  if (out.points.empty()) {
    return BadInput("no stripe is seen on the object; are the lasers on, and is the capture of this device?");
  }
  return out;
}

Result<Reconstruction> Reconstruct(const CaptureImages& capture, const ReadyCalibration& ready,
                                   const ReconstructOptions& options, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(Reconstruction out, ReconstructPoints(capture, ready, options, context));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("fusion", 0.8);
  out.height_field = FuseHeightField(out.points, ready.calibration.device.camera, out.mask.mask,
                                     options.height_field, context);
  out.mesh = MeshHeightField(out.height_field);
  AssignNormals(out.mesh, 5.0, &out.points);
  if (out.mesh.faces.empty()) out.warnings.emplace_back("the points lie too far apart for a mesh");
  return out;
}

}  // namespace dorsum
