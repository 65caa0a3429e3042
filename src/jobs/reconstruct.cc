// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct.h"

#include <cstdint>
#include <cstdio>

#include "base/parallel.h"
#include "captures/green_channel.h"
#include "captures/image_file.h"
#include "imaging/motion.h"
#include "jobs/find_object.h"
#include "jobs/laser_agreement.h"
#include "stripes/order_shift.h"
#include "surface/height_mesh.h"
#include "surface/triangulation.h"

namespace dorsum {
namespace {

Status CheckResolution(const CaptureImages& capture, const Camera& camera) {
  if (capture.hand.cols == camera.width && capture.hand.rows == camera.height) return {};
  return BadInput("the calibration is for images of " + std::to_string(camera.width) + "x" +
                  std::to_string(camera.height) + ", but the capture has " +
                  std::to_string(capture.hand.cols) + "x" + std::to_string(capture.hand.rows) +
                  "; use the calibration of this camera and resolution");
}

Status CheckLasers(const std::vector<int>& wanted, const DeviceGeometry& device) {
  for (const int laser : wanted) {
    if (device.FindLaser(laser) != nullptr) continue;
    return UsageError("--lasers names laser " + std::to_string(laser) +
                      ", which the calibration does not know");
  }
  return {};
}

Status CheckSheets(const ReconstructOptions& options, const DeviceGeometry& device) {
  const bool cone = options.sheets == "cone";
  for (const LaserGeometry& laser : device.lasers) {
    if (cone ? laser.fan.has_value() : !laser.planes.empty()) continue;
    return BadInput("the calibration holds no " + options.sheets + " sheets for laser " +
                    std::to_string(laser.laser) + "; calibrate with --method " +
                    (cone ? "bundle" : "classic") + ", or reconstruct with --sheets " +
                    (cone ? "plane" : "cone"));
  }
  return {};
}

// The stripes' brightness must be that of their orders.
Status CheckOrders(const IndexedStripes& stripes, const cv::Mat& green_hand, const DeviceGeometry& device,
                   const Context& context) {
  const OrderShift found = FindOrderShift(stripes, green_hand, device, {}, context);
  if (found.shift == 0) return {};
  char text[192];
  std::snprintf(
      text, sizeof text,
      "the stripes shine as those of other orders do, so the object reaches out of the working volume of "
      "%.0f to %.0f mm; place it lower and capture again",
      device.min_height_mm, device.max_height_mm);
  return BadInput(text);
}

// Points that the surface of all lasers contradicts are no measurement of it.
void DropOutliers(const std::vector<PointVerdict>& verdicts, SurfacePoints* points) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points->size(); ++i) {
    const bool contradicted =
        verdicts[i] == PointVerdict::kMisplaced || verdicts[i] == PointVerdict::kOutlier;
    if (!contradicted) (*points)[kept++] = (*points)[i];
  }
  points->resize(kept);
}

// Where the capture shows the hand once more at its end.
void WarnOfMotion(const CaptureImages& capture, std::vector<std::string>* warnings) {
  constexpr double kLeastPx = 0.5;
  if (!capture.hand_after) return;
  const PictureMotion motion = MeasureMotion(capture.hand, *capture.hand_after);
  if (motion.shift_px < kLeastPx) return;
  char text[128];
  std::snprintf(text, sizeof text,
                "the object moved by %.1f px or more while it was captured, so heights are worse than their "
                "sigma says; capture again",
                motion.shift_px);
  warnings->emplace_back(text);
}

}  // namespace

Result<ReadyCalibration> PrepareCalibration(Calibration calibration, const std::string& where) {
  ReadyCalibration ready;
  const cv::Size size(calibration.device.camera.width, calibration.device.camera.height);
  DORSUM_ASSIGN_OR_RETURN(ready.background,
                          DecodeImage(calibration.background, where + ": the background image", size));
  ready.green_background = GreenChannel(ready.background);
  ready.orders = std::make_shared<const DeviceOrders>(calibration.device);
  ready.calibration = std::move(calibration);
  return ready;
}

Result<Reconstruction> ReconstructPoints(const CaptureImages& capture, const ReadyCalibration& ready,
                                         const ReconstructOptions& options, const Context& context) {
  const DeviceGeometry& device = ready.calibration.device;
  DORSUM_RETURN_IF_ERROR(CheckResolution(capture, device.camera));
  DORSUM_RETURN_IF_ERROR(CheckLasers(options.lasers, device));
  const ReconstructOptions resolved = ResolveStages(options);
  DORSUM_RETURN_IF_ERROR(CheckSheets(resolved, device));
  Reconstruction out;
  out.warnings = capture.warnings;
  DORSUM_ASSIGN_OR_RETURN(FoundObject found, FindObject(capture, ready, resolved, context));
  out.mask = std::move(found.mask);
  out.stripes = std::move(found.stripes);
  out.warnings.insert(out.warnings.end(), found.warnings.begin(), found.warnings.end());
  for (const LaserStripes& one : out.stripes.lasers) {
    if (one.points.empty()) {
      out.warnings.push_back("laser " + std::to_string(one.laser) +
                             " shows no stripe on the object; is it on?");
    }
  }
  WarnOfMotion(capture, &out.warnings);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("surface", 0.6);
  Status orders_fit;
  Triangulation triangulation;
  ParallelFor(context, 0, resolved.indexing == "joint" ? 2 : 1, [&](std::int64_t task) {
    if (task == 1) {
      orders_fit = CheckOrders(out.stripes, found.green_hand, device, context);
      return;
    }
    triangulation = Triangulate(out.stripes, *ready.orders,
                                {.sheets = resolved.sheets == "cone" ? SheetModel::kCone : SheetModel::kPlane,
                                 .correction = resolved.correction == "polynomial"},
                                context);
  });
  if (!orders_fit.ok()) return orders_fit.error();
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
  const Camera& camera = ready.calibration.device.camera;
  if (ResolveStages(options).fusion == "robust") {
    RobustFusionOptions robust = options.robust_fusion;
    robust.pitch_mm = options.height_field.pitch_mm;
    RobustFusion fusion = FuseRobust(out.points, camera, out.mask.mask, robust, context);
    DORSUM_RETURN_IF_ERROR(CheckAgreement(fusion.lasers, ready.calibration.device));
    DropOutliers(fusion.verdicts, &out.points);
    out.contradicted = fusion.misplaced + fusion.outliers;
    out.height_field = std::move(fusion.field);
    out.mesh = std::move(fusion.mesh);
    out.consistency = std::move(fusion.lasers);
    out.offsets = std::move(fusion.offsets);
  } else {
    out.height_field = FuseHeightField(out.points, camera, out.mask.mask, options.height_field, context);
    out.mesh = MeshHeightField(out.height_field);
  }
  AssignNormals(out.mesh, 5.0, &out.points, context);
  if (out.mesh.faces.empty()) out.warnings.emplace_back("the points lie too far apart for a mesh");
  return out;
}

}  // namespace dorsum
