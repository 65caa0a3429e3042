// SPDX-License-Identifier: Apache-2.0
#include "jobs/find_object.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "captures/green_channel.h"
#include "imaging/object_mask.h"
#include "imaging/shadow.h"
#include "imaging/stage_sink.h"
#include "imaging/unchanged_part.h"
#include "jobs/measure_stripes.h"
#include "jobs/picture_stripes.h"
#include "stripes/object_stripes.h"

namespace dorsum {
namespace {

// Orders for the object's stripes, and what lies on the backplane beside it; and `meanwhile`, which needs no
// orders.
void Index(PictureStripes seen, const DeviceOrders& orders, const ReconstructOptions& options,
           const Context& context, const std::function<void()>& meanwhile, FoundObject* found) {
  const SheetModel model = options.sheets == "cone" ? SheetModel::kCone : SheetModel::kPlane;
  FoundObject& out = *found;
  if (options.indexing == "joint") {
    ObjectSplit split = SplitByHeight(
        IndexJointly(std::move(seen.stripes), orders, options.joint_indexing, context, meanwhile),
        seen.backplane, orders, options.object_split, context);
    out.stripes = std::move(split.object);
    out.backplane = std::move(split.backplane);
    return;
  }
  meanwhile();
  const DeviceGeometry& device = orders.device();
  std::vector<LaserStripes> object;
  for (BackplaneSplit& split :
       SplitBackplane(seen.stripes, device, options.segments.min_rows, options.backplane)) {
    out.backplane.insert(out.backplane.end(), split.backplane.begin(), split.backplane.end());
    object.push_back(std::move(split.object));
  }
  out.stripes = IndexClassic(std::move(object), device, model, options.classic_indexing);
}

// A lamp that failed or a lens that was covered leaves no part of the picture as it was.
Status CheckLight(const UnchangedPart& unchanged) {
  constexpr double kLeastShare = 0.02;
  if (unchanged.Share(0.4) >= kLeastShare) return {};
  return BadInput(
      "bgHand differs from the background nearly everywhere; the light or the camera changed since the "
      "calibration, so calibrate again");
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
                               const FoundObject& found, const ObjectLight& light,
                               const ReconstructOptions& options, const Context& context) {
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
  return RefineObjectMask(background, capture.hand, light, seeds, options.object_mask, context);
}

}  // namespace

Result<FoundObject> FindObject(const CaptureImages& capture, const ReadyCalibration& ready,
                               const ReconstructOptions& options, const Context& context) {
  const cv::Mat &background = ready.background, &green = ready.green_background;
  const DeviceOrders& orders = *ready.orders;
  const bool robust = options.mask == "robust", ridges = options.stripes == "ridge";
  context.Report("mask", 0.0);
  FoundObject out;
  out.green_hand = GreenChannel(capture.hand, context);
  HandMask picture;
  std::optional<UnchangedPart> unchanged;
  if (robust) {
    unchanged.emplace(green, out.green_hand, context);
    DORSUM_RETURN_IF_ERROR(CheckLight(*unchanged));
    picture.mask = cv::Mat(capture.hand.size(), CV_8UC1, cv::Scalar(255));
  } else {
    DORSUM_ASSIGN_OR_RETURN(picture, ExtractHandMask(background, capture.hand, options.hand_mask, context));
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("stripes", 0.2);
  DORSUM_ASSIGN_OR_RETURN(
      PictureStripes seen,
      FindPictureStripes(capture, picture.mask, unchanged ? &*unchanged : nullptr, orders, options, context));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  context.Report("indexing", 0.5);
  const cv::Mat empty = seen.empty;
  const std::map<int, LaserPicture> pictures = std::move(seen.pictures);
  ObjectLight light;
  Index(
      std::move(seen), orders, options, context,
      [&] {
        if (robust) light = FindObjectLight(green, out.green_hand, empty, context);
      },
      &out);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  if (robust) {
    DORSUM_ASSIGN_OR_RETURN(out.mask, MaskFromSeeds(capture, background, out, light, options, context));
    KeepInside(out.mask.mask, &out.stripes);
    if (ridges) MeasureStripes(out.green_hand, out.mask.mask, pictures, options, context, &out.stripes);
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
  if (ridges) MeasureStripes(out.green_hand, out.mask.mask, pictures, options, context, &out.stripes);
  return out;
}

}  // namespace dorsum
