// SPDX-License-Identifier: Apache-2.0
#include "jobs/find_object.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "base/parallel.h"
#include "captures/green_channel.h"
#include "imaging/object_mask.h"
#include "imaging/shadow.h"
#include "imaging/stage_sink.h"
#include "imaging/unchanged_part.h"
#include "jobs/measure_stripes.h"
#include "stripes/backplane_check.h"
#include "stripes/object_stripes.h"

namespace dorsum {
namespace {

// Lasers that are calibrated, wanted and in the capture.
std::vector<int> LasersToUse(const CaptureImages& capture, const DeviceGeometry& device,
                             const std::vector<int>& wanted) {
  std::vector<int> lasers;
  for (const LaserGeometry& laser : device.lasers) {
    const auto k = static_cast<std::size_t>(laser.laser);
    const bool asked = wanted.empty() || std::find(wanted.begin(), wanted.end(), laser.laser) != wanted.end();
    if (asked && k < capture.stripes.size() && capture.stripes[k]) lasers.push_back(laser.laser);
  }
  return lasers;
}

// What one laser's picture shows, before anything is said about orders.
struct PictureStripes {
  LaserStripes stripes;
  NoiseModel noise;  // of the picture; only ridges measure it
};

PictureStripes FindStripes(const cv::Mat& image, const cv::Mat& region, int laser,
                           const ReconstructOptions& options, const Context& context) {
  const cv::Mat green = GreenChannel(image);
  PictureStripes out;
  if (options.stripes == "ridge") {
    out.stripes = FindRidges(green, region, laser, options.ridge, context, &out.noise);
    return out;
  }
  const cv::Mat stripe_mask =
      ExtractStripeMask(image, region, options.stripe_mask, "stripes/" + std::to_string(laser), context);
  out.stripes = SmoothSegments(ExtractClassicSegments(stripe_mask, green, laser, options.segments),
                               options.segments.min_rows, options.smoothing);
  return out;
}

// StripePoints and StripeSegments of all wanted lasers, side by side.
std::vector<PictureStripes> FindAllStripes(const CaptureImages& capture, const cv::Mat& region,
                                           const DeviceGeometry& device, const ReconstructOptions& options,
                                           const Context& context) {
  const std::vector<int> lasers = LasersToUse(capture, device, options.lasers);
  std::vector<PictureStripes> pictures(lasers.size());
  Context inner = context;
  if (context.sink != nullptr) inner.threads = 1;  // a sink is called from one thread
  ParallelFor(inner, 0, static_cast<std::int64_t>(lasers.size()), [&](std::int64_t i) {
    const int laser = lasers[static_cast<std::size_t>(i)];
    pictures[static_cast<std::size_t>(i)] =
        FindStripes(*capture.stripes[static_cast<std::size_t>(laser)], region, laser, options, inner);
  });
  return pictures;
}

// Orders for the object's stripes, and what lies on the backplane beside it.
FoundObject Index(std::vector<LaserStripes> stripes, const DeviceOrders& orders,
                  const ReconstructOptions& options, const Context& context) {
  const SheetModel model = options.sheets == "cone" ? SheetModel::kCone : SheetModel::kPlane;
  FoundObject out;
  if (options.indexing == "joint") {
    ObjectSplit split =
        SplitByHeight(IndexJointly(std::move(stripes), orders, options.joint_indexing, context), orders,
                      options.object_split, context);
    out.stripes = std::move(split.object);
    out.backplane = std::move(split.backplane);
    return out;
  }
  const DeviceGeometry& device = orders.device();
  std::vector<LaserStripes> object;
  for (BackplaneSplit& split :
       SplitBackplane(stripes, device, options.segments.min_rows, options.backplane)) {
    out.backplane.insert(out.backplane.end(), split.backplane.begin(), split.backplane.end());
    object.push_back(std::move(split.object));
  }
  out.stripes = IndexClassic(std::move(object), device, model, options.classic_indexing);
  return out;
}

// A lamp that failed or a lens that was covered leaves no part of the picture as it was.
Status CheckLight(const UnchangedPart& unchanged) {
  constexpr double kLeastShare = 0.02;
  const cv::Mat similar = unchanged.Mask(0.4);
  if (cv::countNonZero(similar) >= kLeastShare * static_cast<double>(similar.total())) return {};
  return BadInput(
      "bgHand differs from the background nearly everywhere; the light or the camera changed since the "
      "calibration, so calibrate again");
}

Status CheckDevice(const std::vector<LaserStripes>& stripes, const UnchangedPart& unchanged,
                   const DeviceOrders& orders) {
  std::string moved;
  double shift = 0.0;
  for (const BackplaneCheck& check : CheckBackplane(stripes, orders, unchanged.Mask(0.06), {})) {
    if (!check.moved) continue;
    moved += (moved.empty() ? "" : ", ") + std::to_string(check.laser);
    shift = std::max(shift, check.shift_px);
  }
  if (moved.empty()) return {};
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", shift);
  return BadInput("the stripes of laser " + moved + " lie " + text +
                  " px beside their places on the backplane: camera, laser or backplane moved since the "
                  "calibration; calibrate again");
}

// The mask without the shadow that the stripes on the backplane give away.
cv::Mat WithoutShadow(const cv::Mat& mask, const FoundObject& found) {
  std::vector<cv::Point> object, backplane;
  for (const LaserStripes& one : found.stripes.lasers) {
    for (const StripePoint& p : one.points) object.emplace_back(cvRound(p.u), cvRound(p.v));
  }
  for (const StripePoint& p : found.backplane) backplane.emplace_back(cvRound(p.u), cvRound(p.v));
  return RemoveShadow(mask, object, backplane);
}

Result<HandMask> MaskFromSeeds(const CaptureImages& capture, const cv::Mat& background,
                               const FoundObject& found, const ReconstructOptions& options,
                               const Context& context) {
  std::vector<ObjectSeed> seeds;
  for (const LaserStripes& one : found.stripes.lasers) {
    for (const StripeSegment& segment : one.segments) {
      if (!segment.order) continue;
      for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
        const StripePoint& p = one.points[static_cast<std::size_t>(i)];
        seeds.push_back({p.u, p.v, true});
      }
    }
  }
  for (const StripePoint& p : found.backplane) seeds.push_back({p.u, p.v, false});
  return RefineObjectMask(background, capture.hand, seeds, options.object_mask, context);
}

}  // namespace

Result<FoundObject> FindObject(const CaptureImages& capture, const cv::Mat& background,
                               const DeviceOrders& orders, const ReconstructOptions& options,
                               const Context& context) {
  const bool robust = options.mask == "robust", ridges = options.stripes == "ridge";
  context.Report("mask", 0.0);
  HandMask picture;
  std::optional<UnchangedPart> unchanged;
  if (robust) {
    unchanged.emplace(background, capture.hand);
    DORSUM_RETURN_IF_ERROR(CheckLight(*unchanged));
    picture.mask = cv::Mat(capture.hand.size(), CV_8UC1, cv::Scalar(255));
  } else {
    DORSUM_ASSIGN_OR_RETURN(picture, ExtractHandMask(background, capture.hand, options.hand_mask, context));
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("stripes", 0.2);
  std::vector<LaserStripes> stripes;
  std::map<int, NoiseModel> noise;
  for (PictureStripes& one : FindAllStripes(capture, picture.mask, orders.device(), options, context)) {
    noise[one.stripes.laser] = one.noise;
    stripes.push_back(std::move(one.stripes));
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("indexing", 0.5);
  if (robust) DORSUM_RETURN_IF_ERROR(CheckDevice(stripes, *unchanged, orders));
  FoundObject out = Index(std::move(stripes), orders, options, context);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  if (robust) {
    DORSUM_ASSIGN_OR_RETURN(out.mask, MaskFromSeeds(capture, background, out, options, context));
    KeepInside(out.mask.mask, &out.stripes);
    if (ridges) MeasureStripes(capture, out.mask.mask, noise, options, context, &out.stripes);
    return out;
  }
  out.mask = picture;
  out.mask.mask = WithoutShadow(picture.mask, out);
  Sink(context, "mask/without_shadow", out.mask.mask);
  out.mask.area_share =
      static_cast<double>(cv::countNonZero(out.mask.mask)) / static_cast<double>(out.mask.mask.total());
  if (out.mask.area_share < options.hand_mask.min_area_share) {
    return BadInput(
        "only shadow is seen in bgHand: the object is as bright as the backplane, or it is gone; cover a "
        "white object with something darker and capture again");
  }
  if (ridges) MeasureStripes(capture, out.mask.mask, noise, options, context, &out.stripes);
  return out;
}

}  // namespace dorsum
