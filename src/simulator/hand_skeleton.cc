// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_skeleton.h"

#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

// Where the joints lie inside the hand: shares that look right on dorsal photographs and X-rays.
constexpr std::array<double, 4> kMcpAcross = {0.322, 0.092, -0.122, -0.322};  // of the palm's breadth
constexpr std::array<double, 4> kMcpHeight = {0.56, 0.585, 0.555, 0.49};      // of the palm's thickness
constexpr std::array<double, 4> kCarpalAcross = {0.20, 0.06, -0.09, -0.23};   // of the wrist's breadth
constexpr double kCarpalAlong = 0.20;  // of the palm's length, from the wrist
constexpr double kPadPress = 0.5;      // mm that a finger pad is pressed flat

double Lerp(double a, double b, double t) { return a + (b - a) * t; }

// Pitch of the proximal link that lets the pad of the distal link touch the plane.
double RestingPitch(const FingerShape& finger, double mcp_height, double pip_flexion, double dip_flexion) {
  auto pad_clearance = [&](double pitch) {
    const double middle = pitch - pip_flexion, distal = middle - dip_flexion;
    const double pad = mcp_height + finger.proximal_link * std::sin(pitch) +
                       finger.middle_link * std::sin(middle) + 0.45 * finger.distal_link * std::sin(distal);
    return pad - (0.54 * finger.dip_depth - kPadPress);
  };
  double lo = Radians(-40), hi = Radians(40);
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (lo + hi);
    (pad_clearance(middle) < 0 ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

FingerBones LayFinger(const FingerShape& finger, const Eigen::Vector3d& carpal, const Eigen::Vector3d& mcp,
                      double azimuth, double pip_flexion, double dip_flexion) {
  FingerBones bones;
  bones.carpal = carpal;
  bones.mcp = mcp;
  bones.direction = {std::cos(azimuth), std::sin(azimuth)};
  const Eigen::Vector2d left(-bones.direction.y(), bones.direction.x());
  auto advance = [&](const Eigen::Vector3d& from, double length, double pitch, double sideways) {
    const Eigen::Vector2d flat = length * std::cos(pitch) * bones.direction + sideways * left;
    return Eigen::Vector3d(from.x() + flat.x(), from.y() + flat.y(), from.z() + length * std::sin(pitch));
  };
  const double pitch = RestingPitch(finger, mcp.z(), pip_flexion, dip_flexion);
  bones.pip = advance(mcp, finger.proximal_link, pitch, 0.7 * finger.bow);
  bones.dip = advance(bones.pip, finger.middle_link, pitch - pip_flexion, 0.3 * finger.bow);
  bones.tip = advance(bones.dip, finger.distal_link, pitch - pip_flexion - dip_flexion, -0.5 * finger.bow);
  return bones;
}

struct Disc {
  Eigen::Vector2d centre;
  double radius;
};

// The outline of a finger beyond its web as discs along its axis.
std::vector<Disc> Outline(const FingerShape& finger, const FingerBones& bones) {
  std::vector<Disc> discs;
  const double pip = 0.5 * finger.pip_breadth, dip = 0.5 * finger.dip_breadth;
  auto add = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double from, double ra, double rb) {
    for (int k = 0; k <= 10; ++k) {
      const double t = Lerp(from, 1.0, k / 10.0);
      discs.push_back({(a + t * (b - a)).head<2>(), Lerp(ra, rb, t)});
    }
  };
  add(bones.mcp, bones.pip, 0.65, pip, pip);
  add(bones.pip, bones.dip, 0.0, pip, dip);
  add(bones.dip, bones.dip + 0.65 * (bones.tip - bones.dip), 0.0, dip, 0.9 * dip);
  return discs;
}

double Gap(const std::vector<Disc>& a, const std::vector<Disc>& b) {
  double gap = 1e9;
  for (const Disc& p : a) {
    for (const Disc& q : b) gap = std::min(gap, (p.centre - q.centre).norm() - p.radius - q.radius);
  }
  return gap;
}

ThumbBones LayThumb(const HandShape& shape, const HandPose& pose, double wrist_x) {
  const ThumbShape& thumb = shape.thumb;
  ThumbBones bones;
  bones.cmc = {wrist_x + 0.15 * shape.palm_length, 0.36 * shape.wrist_breadth, 0.58 * shape.palm_thickness};
  // The tilted section's lowest point touches the plane at the tip; at the metacarpal it floats in the
  // thenar.
  auto rest = [&](double half_breadth, double half_depth) {
    return std::hypot(half_breadth * std::sin(pose.thumb_roll), half_depth * std::cos(pose.thumb_roll)) -
           kPadPress;
  };
  auto advance = [](const Eigen::Vector3d& from, double length, double azimuth, double height) {
    const double flat = std::sqrt(std::max(length * length - std::pow(height - from.z(), 2), 1.0));
    return Eigen::Vector3d(from.x() + flat * std::cos(azimuth), from.y() + flat * std::sin(azimuth), height);
  };
  double azimuth = pose.thumb_abduction;
  const double ip_height = rest(0.5 * thumb.ip_breadth, 0.5 * thumb.ip_depth);
  bones.mcp = advance(bones.cmc, thumb.metacarpal_link, azimuth, ip_height + 2.5);
  azimuth -= pose.thumb_mcp_bend;
  bones.ip = advance(bones.mcp, thumb.proximal_link, azimuth, ip_height + 0.8);
  azimuth -= pose.thumb_ip_bend;
  bones.tip = advance(bones.ip, thumb.distal_link, azimuth, 0.80 * ip_height);
  return bones;
}

}  // namespace

double PalmBreadth(const HandShape& shape, const HandPose& pose) {
  const double mean_spread = (pose.spread[0] + pose.spread[1] + pose.spread[2]) / 3;
  return Lerp(shape.hand_breadth, shape.hand_breadth_open, std::clamp(mean_spread / Radians(12), 0.0, 1.0));
}

HandSkeleton BuildSkeleton(const HandShape& shape, const HandPose& pose) {
  HandSkeleton skeleton;
  const double wrist_x = -0.5 * shape.hand_length;
  const double breadth = PalmBreadth(shape, pose);
  skeleton.wrist = {wrist_x, 0, 0.5 * shape.WristDepth()};
  skeleton.forearm = {-std::cos(pose.wrist_deviation), -std::sin(pose.wrist_deviation)};

  const auto& crotch = shape.crotch_height;
  const std::array<double, 4> base = {crotch[1] - 2.0, 0.5 * (crotch[1] + crotch[2]),
                                      0.5 * (crotch[2] + crotch[3]), crotch[3] - 3.5};
  std::array<Eigen::Vector3d, 4> carpal, mcp;
  for (int i = 0; i < 4; ++i) {
    const FingerShape& finger = shape.fingers[i];
    const double chain = finger.proximal_link + finger.middle_link + finger.distal_link;
    mcp[i] = {wrist_x + base[i] + finger.length - chain, kMcpAcross[i] * breadth,
              kMcpHeight[i] * shape.palm_thickness};
    carpal[i] = {wrist_x + kCarpalAlong * shape.palm_length, kCarpalAcross[i] * shape.wrist_breadth,
                 0.52 * shape.WristDepth()};
  }
  std::array<double, 4> azimuth;
  azimuth[1] = pose.middle_deviation;
  azimuth[0] = azimuth[1] + pose.spread[0];
  azimuth[2] = azimuth[1] - pose.spread[1];
  azimuth[3] = azimuth[2] - pose.spread[2];
  auto lay = [&](int i) {
    skeleton.fingers[i] =
        LayFinger(shape.fingers[i], carpal[i], mcp[i], azimuth[i], pose.pip_flexion[i], pose.dip_flexion[i]);
  };
  auto open = [&](int inner, int outer, double step) {
    for (int k = 0; k < 60; ++k) {
      lay(outer);
      if (Gap(Outline(shape.fingers[inner], skeleton.fingers[inner]),
              Outline(shape.fingers[outer], skeleton.fingers[outer])) >= kFingerClearance) {
        return;
      }
      azimuth[outer] += step;
      if (outer == 2) azimuth[3] += step;
    }
  };
  lay(1);
  open(1, 0, Radians(0.25));
  open(1, 2, Radians(-0.25));
  open(2, 3, Radians(-0.25));
  skeleton.thumb = LayThumb(shape, pose, wrist_x);

  for (int i = 1; i < 4; ++i) {
    // On the bisector of the two fingers, at the crotch's height.
    const FingerBones &a = skeleton.fingers[i - 1], &b = skeleton.fingers[i];
    const double x = wrist_x + crotch[i];
    auto at = [&](const FingerBones& bones) {
      return bones.mcp.y() + (x - bones.mcp.x()) * bones.direction.y() / bones.direction.x();
    };
    skeleton.crotches[i] = {x, 0.5 * (at(a) + at(b)), 0.30 * (a.mcp.z() + b.mcp.z()) / 2 + 2.0};
  }
  const Eigen::Vector3d middle = 0.5 * (skeleton.thumb.mcp + skeleton.fingers[0].mcp);
  skeleton.crotches[0] = {wrist_x + crotch[0], middle.y(), 0.5 * middle.z()};
  return skeleton;
}

Eigen::Affine3d WorldFromHand(Side side, const HandPose& pose) {
  Eigen::Affine3d world_from_hand = Eigen::Affine3d::Identity();
  world_from_hand.translate(Eigen::Vector3d(pose.centre.x(), pose.centre.y(), 0));
  world_from_hand.rotate(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()));
  if (side == Side::kLeft) world_from_hand.scale(Eigen::Vector3d(1, -1, 1));
  return world_from_hand;
}

}  // namespace dorsum
