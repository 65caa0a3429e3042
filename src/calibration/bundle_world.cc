// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_world.h"

#include <cmath>

#include <Eigen/Geometry>

namespace dorsum {
namespace {

// Direction of the world's x: perpendicular to the reference laser's central stripe at the origin.
double CentralTurn(const DiffractedFan& fan) {
  // Where order 0 crosses y = +-h on the backplane, by Newton's method on x.
  const auto x_at = [&](double y) {
    double x = fan.origin.x();
    for (int i = 0; i < 30; ++i) {
      const auto here = Locate(fan, {x, y, 0.0}), there = Locate(fan, {x + 1e-3, y, 0.0});
      if (!here || !there) return x;
      const double slope = (there->Order(fan) - here->Order(fan)) / 1e-3;
      const double change = here->Order(fan) / slope;
      x -= change;
      if (std::abs(change) < 1e-12) break;
    }
    return x;
  };
  constexpr double kReach = 5.0;  // mm
  return -std::atan((x_at(kReach) - x_at(-kReach)) / (2.0 * kReach));
}

void TurnWorld(double angle, BundleState* state) {
  Rigid3 new_from_old;
  new_from_old.rotation = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Rigid3 camera = RigidFromPose(state->camera_from_world);
  state->camera_from_world = PoseFromRigid(camera * new_from_old.Inverse());
  for (PoseParameters& pose : state->world_from_board)
    pose = PoseFromRigid(new_from_old * RigidFromPose(pose));
  for (FanParameters& p : state->fans) {
    DiffractedFan fan = GeometryFromFan(p);
    fan.origin = new_from_old * fan.origin;
    fan.a = new_from_old.rotation * fan.a;
    fan.b = new_from_old.rotation * fan.b;
    fan.n = new_from_old.rotation * fan.n;
    p = FanFromGeometry(fan);
  }
  for (auto& plane : state->planes) {
    const Eigen::Vector2d slope =
        new_from_old.rotation.topLeftCorner<2, 2>() * Eigen::Vector2d(plane[1], plane[2]);
    plane[1] = slope.x();
    plane[2] = slope.y();
  }
}

}  // namespace

void TurnWorldToCentral(std::size_t reference, BundleState* state) {
  TurnWorld(CentralTurn(GeometryFromFan(state->fans[reference])), state);
}

}  // namespace dorsum
