// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_bodies.h"

#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

Eigen::Vector2d Flat(const Eigen::Vector3d& p) { return p.head<2>(); }

// A body along a chain of joint centres, seen from above along one line.
class Chain {
 public:
  Chain(const Eigen::Vector3d& origin, const Eigen::Vector2d& direction)
      : origin_(Flat(origin)), along_(direction.normalized()) {}

  void Add(const Eigen::Vector3d& centre, double half_breadth, double dorsal, double palmar) {
    const Eigen::Vector2d flat = Flat(centre) - origin_;
    const double offset = along_.x() * flat.y() - along_.y() * flat.x();
    sections_.push_back({flat.dot(along_), offset, centre.z(), half_breadth, dorsal, palmar});
  }
  // From the plane's level up to `top`, as flesh that rests on it.
  void AddResting(const Eigen::Vector2d& at, double half_breadth, double top) {
    Add({at.x(), at.y(), 0.5 * top}, half_breadth, 0.5 * top, 0.5 * top + 0.4);
  }
  SweptBody Build(const SweptBodyOptions& options) const { return {origin_, along_, sections_, options}; }

 private:
  Eigen::Vector2d origin_;
  Eigen::Vector2d along_;
  std::vector<SweptSection> sections_;
};

template <typename Vector>
Vector Between(const Vector& a, const Vector& b, double t) {
  return a + t * (b - a);
}

SweptBody Finger(const FingerShape& f, const FingerBones& bones) {
  Chain chain(bones.mcp, bones.direction);
  const double b = f.pip_breadth, d = f.pip_depth, db = f.dip_breadth, dd = f.dip_depth;
  const double mb = 0.55 * b + 0.45 * db, md = 0.55 * d + 0.45 * dd;  // middle phalanx
  chain.Add(bones.mcp, 0.52 * b, 0.50 * d, 0.60 * d);
  chain.Add(Between(bones.mcp, bones.pip, 0.40), 0.505 * b, 0.475 * d, 0.58 * d);
  chain.Add(Between(bones.mcp, bones.pip, 0.72), 0.483 * b, 0.465 * d, 0.51 * d);
  chain.Add(bones.pip, 0.50 * b, 0.515 * d, 0.485 * d);
  chain.Add(Between(bones.pip, bones.dip, 0.50), 0.47 * mb, 0.455 * md, 0.53 * md);
  chain.Add(bones.dip, 0.50 * db, 0.51 * dd, 0.49 * dd);
  chain.Add(Between(bones.dip, bones.tip, 0.42), 0.485 * db, 0.42 * dd, 0.54 * dd);
  chain.Add(Between(bones.dip, bones.tip, 0.62), 0.45 * db, 0.35 * dd, 0.49 * dd);
  SweptBodyOptions options;
  options.near_cap = 9;
  options.far_cap = 0.38 * f.distal_link;
  return chain.Build(options);
}

SweptBody Thumb(const ThumbShape& t, const ThumbBones& bones, double roll) {
  Chain chain(bones.cmc, Flat(bones.tip) - Flat(bones.cmc));
  const double b = t.ip_breadth, d = t.ip_depth;
  chain.Add(bones.cmc, 0.54 * b, 0.56 * d, 0.60 * d);
  chain.Add(Between(bones.cmc, bones.mcp, 0.55), 0.51 * b, 0.50 * d, 0.66 * d);
  chain.Add(bones.mcp, 0.545 * b, 0.53 * d, 0.56 * d);
  chain.Add(Between(bones.mcp, bones.ip, 0.55), 0.465 * b, 0.44 * d, 0.50 * d);
  chain.Add(bones.ip, 0.50 * b, 0.50 * d, 0.50 * d);
  chain.Add(Between(bones.ip, bones.tip, 0.40), 0.49 * b, 0.40 * d, 0.53 * d);
  chain.Add(Between(bones.ip, bones.tip, 0.60), 0.45 * b, 0.33 * d, 0.48 * d);
  SweptBodyOptions options;
  options.near_cap = 10;
  options.far_cap = 0.40 * t.distal_link;
  options.roll = roll;
  options.smoothing = 3.0;
  return chain.Build(options);
}

struct Palm {
  double breadth, thickness, wrist_depth, wrist_breadth, length;
  Eigen::Vector2d wrist;
  Eigen::Vector2d At(double along, double across) const {
    return wrist + Eigen::Vector2d(along * length, across);
  }
};

// Heights of the back of the hand over each ray as shares of the palm's thickness at metacarpal 3.
constexpr std::array<double, 4> kRayHeight = {0.945, 0.985, 0.935, 0.815};

SweptBody Metacarpal(const Palm& palm, const FingerShape& finger, const FingerBones& bones, int i) {
  Chain chain(bones.carpal, Flat(bones.mcp) - Flat(bones.carpal));
  constexpr std::array<double, 4> kHeadBreadth = {0.152, 0.135, 0.130, 0.138};
  const double head = kHeadBreadth[i] * palm.breadth, t = palm.thickness * kRayHeight[i];
  const Eigen::Vector2d carpal = Flat(bones.carpal), mcp = Flat(bones.mcp);
  chain.AddResting(carpal, 0.10 * palm.breadth, Between(1.08 * t, palm.wrist_depth, 0.50));
  chain.AddResting(Between(carpal, mcp, 0.45), 0.115 * palm.breadth, 1.07 * t);
  chain.AddResting(Between(carpal, mcp, 0.78), 0.95 * head, 0.985 * t);
  chain.AddResting(mcp, head, 0.945 * t);
  // Runs out inside the finger's base, as the flesh of the distal palm does.
  chain.AddResting(mcp + 0.11 * palm.length * bones.direction, 0.47 * finger.pip_breadth, 0.74 * t);
  SweptBodyOptions options;
  options.near_cap = 12;
  options.far_cap = 14;
  options.smoothing = 3.0;
  return chain.Build(options);
}

constexpr double kElbowwards = 182.0;  // mm from the hand's origin to where the forearm is cut off

SweptBody Forearm(const Palm& palm, const HandSkeleton& skeleton) {
  Chain chain(skeleton.wrist, skeleton.forearm);
  auto add = [&](double s, double breadth, double height) {
    chain.AddResting(palm.wrist + s * skeleton.forearm, 0.5 * breadth * palm.wrist_breadth,
                     height * palm.wrist_depth);
  };
  add(-0.24 * palm.length, 1.00, 0.90);
  add(0, 0.99, 0.97);
  add(20, 0.945, 0.96);
  add(48, 1.0, 1.0);
  add(kElbowwards - std::abs(palm.wrist.x()), 1.12, 1.07);
  SweptBodyOptions options;
  options.near_cap = 18;
  options.far_cap = 4;
  options.exponent = 2.5;
  options.smoothing = 5.0;
  return chain.Build(options);
}

SweptBody PalmSlab(const Palm& palm) {
  Chain chain({palm.wrist.x(), palm.wrist.y(), 0}, Eigen::Vector2d::UnitX());
  chain.AddResting(palm.At(0.10, 0), 0.47 * palm.wrist_breadth, 0.89 * palm.wrist_depth);
  chain.AddResting(palm.At(0.36, 0), 0.395 * palm.breadth, 1.02 * palm.thickness);
  chain.AddResting(palm.At(0.58, 0), 0.40 * palm.breadth, 0.85 * palm.thickness);
  SweptBodyOptions options;
  options.near_cap = 14;
  options.far_cap = 14;
  options.exponent = 2.5;
  options.smoothing = 4.0;
  return chain.Build(options);
}

SweptBody Mound(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double half_from, double half_to,
                double top_from, double top_to, double cap) {
  Chain chain({from.x(), from.y(), 0}, to - from);
  chain.AddResting(from, half_from, top_from);
  chain.AddResting(to, half_to, top_to);
  SweptBodyOptions options;
  options.near_cap = options.far_cap = cap;
  return chain.Build(options);
}

// The last section of a web: its rounded end takes the rest of the way. A web keeps some length.
Eigen::Vector2d WebEnd(const Eigen::Vector2d& from, const Eigen::Vector2d& crotch, double beyond) {
  const double length = (crotch - from).norm();
  return from + std::max(length + beyond, 5.0) / length * (crotch - from);
}

}  // namespace

double AlongBody(const Eigen::Vector3d& origin, const Eigen::Vector2d& direction,
                 const Eigen::Vector3d& point) {
  return (Flat(point) - Flat(origin)).dot(direction.normalized());
}

HandBodies BuildBodies(const HandShape& shape, const HandPose& pose, const HandSkeleton& skeleton) {
  const Palm palm = {PalmBreadth(shape, pose), shape.palm_thickness, shape.WristDepth(),
                     shape.wrist_breadth,      shape.palm_length,    Flat(skeleton.wrist)};
  HandBodies bodies;
  bodies.palm.push_back({Forearm(palm, skeleton), 1.0});
  bodies.palm.push_back({PalmSlab(palm), 20.0});
  for (int i = 0; i < 4; ++i)
    bodies.palm.push_back({Metacarpal(palm, shape.fingers[i], skeleton.fingers[i], i), 9.0});
  const double b = palm.breadth, t = palm.thickness;
  const ThumbBones& thumb = skeleton.thumb;
  const Eigen::Vector2d hypothenar_end =
      Flat(skeleton.fingers[3].mcp) + Eigen::Vector2d(-0.10 * b, -0.035 * b);
  bodies.palm.push_back({Mound(palm.At(0.14, -0.30 * palm.wrist_breadth), hypothenar_end, 0.13 * b, 0.115 * b,
                               0.86 * t, 0.70 * t, 14),
                         16.0});
  bodies.palm.push_back(
      {Mound(palm.At(0.10, 0.22 * palm.wrist_breadth), Between(Flat(thumb.cmc), Flat(thumb.mcp), 0.75),
             0.17 * b, 0.14 * b, 0.95 * t, 0.66 * t, 14),
       16.0});
  const Eigen::Vector2d gap_from = Between(Flat(thumb.cmc), Flat(skeleton.fingers[0].carpal), 0.5);
  const Eigen::Vector2d gap_to =
      Between(Between(Flat(thumb.cmc), Flat(thumb.mcp), 0.8),
              Between(Flat(skeleton.fingers[0].carpal), Flat(skeleton.fingers[0].mcp), 0.85), 0.70);
  bodies.palm.push_back(
      {Mound(Between(gap_from, gap_to, 0.3), gap_to, 0.12 * b, 0.07 * b, 1.0 * t, 0.72 * t, 14), 16.0});
  for (int i = 0; i < 4; ++i) bodies.fingers[i] = Finger(shape.fingers[i], skeleton.fingers[i]);
  bodies.thumb = Thumb(shape.thumb, thumb, pose.thumb_roll);
  return bodies;
}

BlendedBody BuildWeb(const HandShape& shape, const HandSkeleton& skeleton, int i, double beyond) {
  const double b = shape.hand_breadth, t = shape.palm_thickness;
  const Eigen::Vector2d crotch = Flat(skeleton.crotches[i]);
  SweptBodyOptions options;
  if (i == 0) {
    const Eigen::Vector2d from =
        Between(Between(Flat(skeleton.thumb.cmc), Flat(skeleton.thumb.mcp), 0.35),
                Between(Flat(skeleton.fingers[0].carpal), Flat(skeleton.fingers[0].mcp), 0.35), 0.5);
    const Eigen::Vector2d along = (crotch - from).normalized();
    const Eigen::Vector2d end = WebEnd(from, crotch, beyond - 14.0);
    Chain chain({from.x(), from.y(), 0}, along);
    chain.AddResting(from, 0.17 * b, 0.85 * t);
    chain.Add({Between(from, end, 0.6).x(), Between(from, end, 0.6).y(), 0.36 * t}, 0.16 * b, 0.30 * t,
              0.34 * t);
    chain.Add({end.x(), end.y(), 0.33 * t}, 0.15 * b, 0.19 * t, 0.27 * t);
    options.far_cap = 14.0;
    return {chain.Build(options), 20.0};
  }
  const FingerBones &inner = skeleton.fingers[i - 1], &outer = skeleton.fingers[i];
  const double top = t * 0.5 * (kRayHeight[i - 1] + kRayHeight[i]);
  const Eigen::Vector2d from = Between(Flat(inner.mcp), Flat(outer.mcp), 0.5);
  const Eigen::Vector2d along = (crotch - from).normalized();
  const Eigen::Vector2d end = WebEnd(from, crotch, beyond - 9.0);
  Chain chain({from.x(), from.y(), 0}, along);
  chain.AddResting(from, 0.10 * b, 0.90 * top);
  chain.AddResting(Between(from, end, 0.6), 0.09 * b, 0.74 * top);
  chain.AddResting(end, 0.07 * b, 0.56 * top);
  options.far_cap = 9.0;
  return {chain.Build(options), 10.0};
}

}  // namespace dorsum
