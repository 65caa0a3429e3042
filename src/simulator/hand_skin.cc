// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_skin.h"

#include <algorithm>
#include <cmath>

#include "simulator/smooth_blend.h"

namespace dorsum {
namespace {

constexpr double kFingerBlend = 11.0;  // mm: fingers into the palm
constexpr double kThumbBlend = 14.0;
constexpr double kNeighbourBlend = 5.0;  // between fingers: 0.05 mm more breadth at kFingerClearance
constexpr double kContactBlend = 2.5;    // edge of the flesh flattened on the plane
constexpr double kDetailReach = 3.0;     // details are left out farther from the skin than this

std::vector<FingerDetail> FingerDetails(const HandShape& shape, const HandSkeleton& skeleton) {
  std::vector<FingerDetail> details;
  const ThumbBones& bones = skeleton.thumb;
  const Eigen::Vector2d along = (bones.tip - bones.cmc).head<2>();
  Rng thumb_rng(NamedSeed("thumb", shape.detail.seed));
  const double thumb_tip = AlongBody(bones.cmc, along, bones.tip), crease = shape.detail.crease;
  details.emplace_back(
      std::vector<FingerDetail::Joint>{
          {AlongBody(bones.cmc, along, bones.ip), 0.5 * shape.thumb.ip_breadth, 0.9 * crease, 5},
          {AlongBody(bones.cmc, along, bones.mcp), 0.55 * shape.thumb.ip_breadth, 0.4 * crease, 3}},
      thumb_tip - 1.8 - shape.thumb.nail_length, shape.thumb.nail_breadth, shape.thumb.nail_length,
      thumb_rng);
  for (int i = 0; i < 4; ++i) {
    const FingerShape& finger = shape.fingers[i];
    const FingerBones& f = skeleton.fingers[i];
    Rng rng(NamedSeed("finger", shape.detail.seed + i));
    const double tip = AlongBody(f.mcp, f.direction, f.tip);
    details.emplace_back(
        std::vector<FingerDetail::Joint>{
            {AlongBody(f.mcp, f.direction, f.pip), 0.5 * finger.pip_breadth, crease, 7},
            {AlongBody(f.mcp, f.direction, f.dip), 0.5 * finger.dip_breadth, 0.65 * crease, 3}},
        tip - 1.6 - finger.nail_length, finger.nail_breadth, finger.nail_length, rng);
  }
  return details;
}

}  // namespace

HandSkin::HandSkin(const HandShape& shape, const HandPose& pose)
    : shape_(shape),
      skeleton_(BuildSkeleton(shape, pose)),
      bodies_(BuildBodies(shape, pose, skeleton_)),
      details_(FingerDetails(shape, skeleton_)),
      dorsum_(shape, skeleton_),
      relief_(NamedSeed("relief", shape.detail.seed), 9.0),
      mottling_(NamedSeed("mottling", shape.detail.seed), 11.0) {
  FitWebs();
}

double HandSkin::WebEnd(int i) const {
  // Along the line from the knuckles through the crotch, at the web's own height, outwards from the palm.
  const Eigen::Vector3d crotch = skeleton_.crotches[i];
  const Eigen::Vector3d from = i == 0 ? 0.5 * (skeleton_.thumb.mcp + skeleton_.fingers[0].mcp)
                                      : 0.5 * (skeleton_.fingers[i - 1].mcp + skeleton_.fingers[i].mcp);
  Eigen::Vector3d along = crotch - from;
  if (i == 0) along = crotch - 0.5 * (skeleton_.thumb.cmc + skeleton_.fingers[0].carpal);
  along.z() = 0;
  along.normalize();
  double lo = -14, hi = 25;
  for (double at = lo; at < hi; at += 1.0) {
    if (Smooth(crotch + at * along).distance > 0) {
      hi = at;
      break;
    }
    lo = at;
  }
  for (int step = 0; step < 20; ++step) {
    const double middle = 0.5 * (lo + hi);
    (Smooth(crotch + middle * along).distance > 0 ? hi : lo) = middle;
  }
  return 0.5 * (lo + hi);
}

void HandSkin::FitWebs() {
  std::array<double, 4> beyond = {};
  for (int i = 0; i < 4; ++i) webs_[i] = BuildWeb(shape_, skeleton_, i, 0);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 4; ++i) {
      beyond[i] = std::clamp(beyond[i] - WebEnd(i), -14.0, 8.0);
      webs_[i] = BuildWeb(shape_, skeleton_, i, beyond[i]);
    }
  }
}

HandSkin::Blend HandSkin::Smooth(const Eigen::Vector3d& point) const {
  Blend blend = {};
  double palm = 1e9;
  for (const BlendedBody& part : bodies_.palm)
    palm = SmoothUnion(palm, part.body.Distance(point), part.blend);
  blend.place = bodies_.thumb.Locate(point);
  blend.finger = bodies_.thumb.DistanceAt(blend.place);
  palm = SmoothUnion(palm, blend.finger, kThumbBlend);
  for (const BlendedBody& web : webs_) palm = SmoothUnion(palm, web.body.Distance(point), web.blend);
  double fingers = 1e9;
  for (int i = 0; i < 4; ++i) {
    const SweptBody::Place place = bodies_.fingers[i].Locate(point);
    const double distance = bodies_.fingers[i].DistanceAt(place);
    fingers = SmoothUnion(fingers, distance, kNeighbourBlend);
    if (distance < blend.finger) {
      blend.finger = distance;
      blend.place = place;
      blend.digit = i + 1;
    }
  }
  blend.distance = SmoothUnion(palm, fingers, kFingerBlend);
  return blend;
}

SkinDetail HandSkin::DetailAt(const Eigen::Vector3d& point, const Blend& blend) const {
  // A finger's details fade where its own surface sinks into the palm's.
  const double on_finger = SmoothStep(3.0, 1.0, blend.finger - blend.distance);
  SkinDetail detail;
  if (on_finger > 0) detail = details_[blend.digit].At(blend.place);
  for (double* share : {&detail.height, &detail.crease, &detail.nail, &detail.pale, &detail.flush})
    *share *= on_finger;
  detail.height += dorsum_.Height(point) + dorsum_.Vein(point);
  detail.height += shape_.detail.relief * (1 - detail.nail) * relief_.At(point);
  return detail;
}

double HandSkin::Distance(const Eigen::Vector3d& point) const {
  const Blend blend = Smooth(point);
  double distance = blend.distance;
  // Deep in the flesh over its contact with the plane no detail can show.
  if (distance + kDetailReach < -point.z() - kContactBlend) return -point.z();
  if (std::abs(distance) < kDetailReach + 1) {
    distance -=
        SmoothStep(kDetailReach + 1, kDetailReach, std::abs(distance)) * DetailAt(point, blend).height;
  }
  return SmoothIntersection(distance, -point.z(), kContactBlend);
}

Eigen::Vector3f HandSkin::Albedo(const Eigen::Vector3d& point) const {
  const Blend blend = Smooth(point);
  const SkinDetail detail = DetailAt(point, blend);
  Eigen::Vector3d colour = shape_.detail.skin.cast<double>();
  const double mottle = mottling_.At(point);
  colour.array() *= 1.0 + 0.025 * mottle * Eigen::Array3d(0.7, 1.0, 1.0);
  // Blood shows over the joints and at the fingers' ends, blue over veins, and skin pales towards the palm.
  const double flush = std::min(1.0, detail.flush);
  colour.array() *= 1.0 - flush * Eigen::Array3d(0.02, 0.10, 0.10);
  colour.array() *= 1.0 - std::min(1.0, 2 * dorsum_.Vein(point)) * Eigen::Array3d(0.09, 0.05, 0.03);
  colour.array() *= 1.0 + 0.10 * SmoothStep(9.0, 3.0, point.z()) * Eigen::Array3d(1.0, 0.9, 0.9);
  colour.array() *= 1.0 - detail.crease * Eigen::Array3d(0.20, 0.28, 0.28);
  const Eigen::Vector3d nail = colour.cwiseProduct(Eigen::Vector3d(1.12, 1.10, 1.18));
  const Eigen::Vector3d pale = colour.cwiseProduct(Eigen::Vector3d(1.25, 1.45, 1.55));
  colour += detail.nail * (nail - colour);
  colour += detail.pale * (pale - colour);
  return colour.cwiseMax(0.02).cwiseMin(0.95).cast<float>();
}

double HandSkin::Nail(const Eigen::Vector3d& point) const {
  return std::clamp(DetailAt(point, Smooth(point)).nail, 0.0, 1.0);
}

void HandSkin::Bounds(Eigen::Vector3d& lo, Eigen::Vector3d& hi) const {
  constexpr double kMargin = 6.0;
  lo.setConstant(1e9);
  hi.setConstant(-1e9);
  for (const BlendedBody& part : bodies_.palm) part.body.GrowBounds(lo, hi, kMargin);
  for (const SweptBody& finger : bodies_.fingers) finger.GrowBounds(lo, hi, kMargin);
  bodies_.thumb.GrowBounds(lo, hi, kMargin);
  lo.z() = -2.0;
}

}  // namespace dorsum
