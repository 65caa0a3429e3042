// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_detail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/smooth_blend.h"

namespace dorsum {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

double Bell(double x) { return x > 16 ? 0.0 : std::exp(-x); }  // of a squared, halved ratio

}  // namespace

FingerDetail::FingerDetail(const std::vector<Joint>& joints, double nail_from, double nail_breadth,
                           double nail_length, Rng& rng)
    : joints_(joints),
      nail_middle_(nail_from + 0.5 * nail_length),
      nail_half_breadth_(0.5 * nail_breadth),
      nail_half_length_(0.5 * nail_length) {
  for (const Joint& joint : joints) {
    const int half = joint.wrinkles / 2;
    const double pitch = 0.20 * joint.half_width;
    for (int k = -half; k <= half; ++k) {
      Wrinkle wrinkle;
      wrinkle.s = joint.s + (k + 0.25 * rng.Uniform(-1, 1)) * pitch;
      wrinkle.depth = joint.depth * (1.0 - 0.22 * std::abs(k)) * rng.Uniform(0.7, 1.1);
      wrinkle.bow = -0.40 * k * pitch + 0.12 * pitch * rng.Normal();  // the outer ones bend round the joint
      wrinkle.reach = rng.Uniform(0.70, 0.95) - 0.06 * std::abs(k);
      wrinkle.wave = rng.Uniform(0.1, 0.3);
      wrinkle.phase = rng.Uniform(0, kTwoPi);
      wrinkles_.push_back(wrinkle);
    }
  }
}

void FingerDetail::AddWrinkles(const SweptBody::Place& place, double dorsal, SkinDetail& detail) const {
  const double across = place.u / place.half_breadth;
  for (const Joint& joint : joints_) {
    const double reach = 0.9 * joint.half_width;
    detail.flush += dorsal * Bell(std::pow((place.s - joint.s) / reach, 2));
    // Loose skin gathers into a low cushion around the wrinkles.
    detail.height += 0.45 * joint.depth * dorsal * Bell(std::pow((place.s - joint.s) / (0.62 * reach), 2));
  }
  constexpr double kWidth = 0.70;  // mm
  for (const Wrinkle& wrinkle : wrinkles_) {
    const double line =
        wrinkle.s + wrinkle.bow * across * across + wrinkle.wave * std::sin(5 * across + wrinkle.phase);
    const double offset = (place.s - line) / kWidth;
    if (std::abs(offset) > 4) continue;
    const double share = dorsal * SmoothStep(wrinkle.reach + 0.1, wrinkle.reach - 0.5, std::abs(across)) *
                         Bell(offset * offset);
    detail.height -= wrinkle.depth * share;
    detail.crease = std::max(detail.crease, share * std::min(1.0, wrinkle.depth / 0.3));
  }
}

void FingerDetail::AddNail(const SweptBody::Place& place, double dorsal, SkinDetail& detail) const {
  const double x = place.s - nail_middle_, y = place.u;
  if (std::abs(x) > nail_half_length_ + 4 || dorsal <= 0) return;
  // Signed distance to a rounded rectangle: round at the cuticle and rounder at the free edge.
  const double corner = (x < 0 ? 0.62 : 0.80) * nail_half_breadth_;
  const double qx = std::abs(x) - nail_half_length_ + corner, qy = std::abs(y) - nail_half_breadth_ + corner;
  const double edge =
      std::hypot(std::max(qx, 0.0), std::max(qy, 0.0)) + std::min(std::max(qx, qy), 0.0) - corner;
  const double rear =
      SmoothStep(nail_half_length_, 0.3 * nail_half_length_, x);  // folds: not at the free edge
  const double plate = dorsal * SmoothStep(0.8, -0.6, edge);
  detail.nail = plate;
  detail.height += dorsal * (0.30 * rear * Bell(std::pow((edge - 1.1) / 0.9, 2)) -
                             0.28 * rear * Bell(std::pow(edge / 0.75, 2)));
  // The plate is flatter than the flesh: its middle lies a little lower, its free edge stands out.
  const double across = y / nail_half_breadth_;
  detail.height +=
      plate * (-0.22 * (1 - across * across) + 0.30 * SmoothStep(0.2, 0.9, x / nail_half_length_));
  const double lunula =
      std::hypot((x + nail_half_length_) / (0.42 * nail_half_length_), y / (0.62 * nail_half_breadth_));
  const double free_edge = SmoothStep(-1.5, -0.7, edge) * SmoothStep(0.45, 0.75, x / nail_half_length_);
  detail.pale = plate * std::max(0.6 * SmoothStep(1.3, 0.7, lunula), free_edge);
}

SkinDetail FingerDetail::At(const SweptBody::Place& place) const {
  SkinDetail detail;
  if (place.outside > 0.5) return detail;
  const double up = place.v / place.half_depth;
  const double dorsal =
      SmoothStep(0.0, 0.55, up / std::max(1e-6, std::hypot(up, place.u / place.half_breadth)));
  if (dorsal <= 0) return detail;
  AddWrinkles(place, dorsal, detail);
  AddNail(place, dorsal, detail);
  detail.flush += 0.5 * dorsal * SmoothStep(nail_middle_, nail_middle_ + nail_half_length_ + 3, place.s);
  return detail;
}

DorsumDetail::DorsumDetail(const HandShape& shape, const HandSkeleton& skeleton) {
  Rng rng(NamedSeed("dorsum", shape.detail.seed));
  const Eigen::Vector2d wrist = skeleton.wrist.head<2>();
  const double size = shape.palm_length / 116.5;
  // Shares of the wrist's breadth: the tendons leave it as one bundle.
  constexpr std::array<double, 4> kAtWrist = {0.11, 0.05, -0.03, -0.11};
  for (int i = 0; i < 4; ++i) {
    const FingerBones& bones = skeleton.fingers[i];
    const Eigen::Vector2d from = wrist + Eigen::Vector2d(4 * size, kAtWrist[i] * shape.wrist_breadth);
    const Eigen::Vector2d mcp = bones.mcp.head<2>();
    tendons_.push_back({from, mcp, shape.detail.tendon[i], 2.0 * size});
    bumps_.push_back({bones.mcp, shape.detail.knuckle[i], 9.0 * size, 6.5 * size});
    if (i == 0) continue;
    const Eigen::Vector3d valley =
        0.5 * (bones.mcp + skeleton.fingers[i - 1].mcp) + Eigen::Vector3d(5 * size, 0, 0);
    const double depth = 0.30 * (shape.detail.knuckle[i] + shape.detail.knuckle[i - 1]);
    bumps_.push_back({valley, -depth, 10 * size, 3.6 * size});
  }
  const Eigen::Vector2d thumb_from = wrist + Eigen::Vector2d(2 * size, 0.24 * shape.wrist_breadth);
  tendons_.push_back({thumb_from, skeleton.thumb.mcp.head<2>(), 0.8 * shape.detail.tendon[0], 2.2 * size});
  // The head of the ulna shows on the little finger's side, before the wrist.
  const Eigen::Vector2d ulna =
      wrist + 15 * size * skeleton.forearm + Eigen::Vector2d(0, -0.34 * shape.wrist_breadth);
  bumps_.push_back({{ulna.x(), ulna.y(), 0.8 * shape.WristDepth()},
                    1.6 + 0.5 * shape.detail.knuckle[3],
                    9 * size,
                    8 * size});

  for (int i = 1; i < 4; ++i) {
    const FingerBones &a = skeleton.fingers[i - 1], &b = skeleton.fingers[i];
    VeinLine vein;
    const double at = rng.Uniform(0.35, 0.65), shift = rng.Uniform(-5, 5);
    vein.from = a.carpal.head<2>() + at * (b.carpal - a.carpal).head<2>() + Eigen::Vector2d(-4, shift);
    vein.to = a.mcp.head<2>() + at * (b.mcp - a.mcp).head<2>() + Eigen::Vector2d(4, 0);
    vein.height = shape.detail.vein * rng.Uniform(0.5, 1.2);
    vein.width = rng.Uniform(1.4, 2.0);
    vein.wave = rng.Uniform(0.8, 1.8);
    vein.length = rng.Uniform(34, 60);
    vein.phase = rng.Uniform(0, kTwoPi);
    veins_.push_back(vein);
  }
}

double DorsumDetail::Height(const Eigen::Vector3d& point) const {
  double height = 0;
  for (const Ridge& ridge : tendons_) {
    const Eigen::Vector2d along = ridge.to - ridge.from, at = point.head<2>() - ridge.from;
    const double length = along.norm(), t = at.dot(along) / (length * length);
    if (t < 0 || t > 1.15) continue;
    const double off = (along.x() * at.y() - along.y() * at.x()) / length;
    if (std::abs(off) > 6 * ridge.width) continue;
    const double width = ridge.width * (0.85 + 0.4 * t);
    height += ridge.height * SmoothStep(0.0, 0.8, t) * SmoothStep(1.15, 0.85, t) *
              Bell(0.5 * off * off / (width * width));
  }
  for (const Bump& bump : bumps_) {
    const double along = (point.x() - bump.centre.x()) / bump.along;
    const double across = (point.y() - bump.centre.y()) / bump.across;
    height += bump.height * Bell(0.5 * (along * along + across * across));
  }
  return height;
}

double DorsumDetail::Vein(const Eigen::Vector3d& point) const {
  double share = 0;
  for (const VeinLine& vein : veins_) {
    const Eigen::Vector2d along = vein.to - vein.from, at = point.head<2>() - vein.from;
    const double length = along.norm(), t = at.dot(along) / (length * length);
    if (t < 0 || t > 1) continue;
    const double aside = (along.x() * at.y() - along.y() * at.x()) / length;
    if (std::abs(aside) > vein.wave + 5 * vein.width) continue;
    const double off = aside - vein.wave * std::sin(kTwoPi * t * length / vein.length + vein.phase);
    share += vein.height * SmoothStep(0, 0.25, t) * SmoothStep(1, 0.75, t) *
             Bell(0.5 * off * off / (vein.width * vein.width));
  }
  return share;
}

}  // namespace dorsum
