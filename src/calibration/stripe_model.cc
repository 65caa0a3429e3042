// SPDX-License-Identifier: Apache-2.0
#include "calibration/stripe_model.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "calibration/turn.h"

namespace dorsum {
namespace {

// Newton's method goes on until what it still misses is squared away by its last step.
constexpr double kNear = 1e-7;

}  // namespace

struct StripeModel::Undistorted {
  double x = 0.0, y = 0.0;
  Eigen::Vector2d distorted;
  Eigen::Matrix2d inverse;    // d (x, y) / d distorted
  Eigen::Vector3d direction;  // world, of the ray whose depth grows by 1
  double depth = 0.0;         // of the place on the plane
  double descent = 0.0;       // how fast the ray rises over the plane, mm for each mm of depth
};

// DiffractedFan's Locate() with derivatives: those of the order by the place in the grating's frame, and by
// the fan's shape.
struct StripeModel::InFan {
  double order = 0.0;
  Eigen::Vector3d local, by_local;
  double by_distance = 0.0, by_alpha = 0.0, by_skew = 0.0, by_bow = 0.0;
};

StripeModel::StripeModel(const LensParameters& lens, const PoseParameters& camera_from_world,
                         const FanParameters& fan, const std::array<double, kPlaneSize>& plane)
    : lens_(lens), plane_(plane), fan_(fan.value) {
  const Eigen::Map<const Eigen::Vector3d> turn(camera_from_world.value.data());
  const Eigen::Map<const Eigen::Vector3d> translation(camera_from_world.value.data() + 3);
  camera_from_world_ = camera_from_world.start * TurnMatrix(turn);
  camera_turn_ = TurnGrowth(turn);
  centre_ = -(camera_from_world_.transpose() * translation);
  normal_ = {-plane[1], -plane[2], 1.0};
  const Eigen::Map<const Eigen::Vector3d> fan_turn(fan.value.data() + kFanTurn);
  axes_ = TurnMatrix(fan_turn) * fan.start;
  fan_turn_ = TurnMatrix(fan_turn) * TurnGrowth(fan_turn);
}

StripeModel::Undistorted StripeModel::Undistort(const Eigen::Vector2d& pixel, StripeSearch* search) const {
  const auto& k = lens_.value;
  Undistorted at;
  at.distorted = {(pixel.x() - k[2]) / k[0], (pixel.y() - k[3]) / k[1]};
  at.x = search->begun ? search->x : at.distorted.x();
  at.y = search->begun ? search->y : at.distorted.y();
  for (int i = 0; i < 20; ++i) {
    const double x = at.x, y = at.y, r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (k[4] + r2 * (k[5] + r2 * k[8]));
    const double slope = 2.0 * (k[4] + r2 * (2.0 * k[5] + r2 * 3.0 * k[8]));
    const double miss_x = x * radial + 2.0 * k[6] * x * y + k[7] * (r2 + 2.0 * x * x) - at.distorted.x();
    const double miss_y = y * radial + k[6] * (r2 + 2.0 * y * y) + 2.0 * k[7] * x * y - at.distorted.y();
    const double xx = radial + slope * x * x + 2.0 * k[6] * y + 6.0 * k[7] * x;
    const double xy = slope * x * y + 2.0 * k[6] * x + 2.0 * k[7] * y;
    const double yy = radial + slope * y * y + 6.0 * k[6] * y + 2.0 * k[7] * x;
    const double share = 1.0 / (xx * yy - xy * xy);
    at.inverse << yy * share, -xy * share, -xy * share, xx * share;
    at.x -= at.inverse(0, 0) * miss_x + at.inverse(0, 1) * miss_y;
    at.y -= at.inverse(1, 0) * miss_x + at.inverse(1, 1) * miss_y;
    if (std::abs(miss_x) + std::abs(miss_y) < kNear) break;
  }
  search->x = at.x;
  search->y = at.y;
  at.direction = camera_from_world_.transpose() * Eigen::Vector3d(at.x, at.y, 1.0);
  at.descent = normal_.dot(at.direction);
  at.depth = (plane_[0] - normal_.dot(centre_)) / at.descent;
  return at;
}

StripeModel::InFan StripeModel::FindInFan(const Eigen::Vector3d& place, StripeSearch* search) const {
  InFan out;
  out.local = axes_.transpose() * (place - Eigen::Map<const Eigen::Vector3d>(fan_.data() + kFanOrigin));
  const double x = out.local.x(), y = out.local.y(), z = out.local.z();
  const double distance = fan_[kFanDistance], a0 = fan_[kFanAlpha], skew = fan_[kFanSkew],
               bow = fan_[kFanBow], step = fan_[kFanStep];
  double beta = search->begun ? search->beta : y / out.local.norm();
  for (int i = 0;; ++i) {
    // The ray of this beta leaves the grating at y_g; what reaches the place from there has beta uy.
    const double root = std::sqrt(1.0 - beta * beta);
    const double alpha = a0 + skew * beta + bow * (root - 1.0);
    const double alpha_by_beta = skew - bow * beta / root;
    const double gamma = 1.0 / std::sqrt(1.0 - alpha * alpha - beta * beta);
    const double y_by_distance = beta * gamma, y_g = distance * y_by_distance;
    const double cube = distance * gamma * gamma * gamma;
    const double y_by_alpha = cube * beta * alpha;
    const double y_by_beta = distance * gamma + cube * beta * (alpha * alpha_by_beta + beta);
    const double dx = x - skew * y_g, dy = y - y_g;
    const double length = 1.0 / std::sqrt(dx * dx + dy * dy + z * z);
    const double ux = dx * length, uy = dy * length, uz = z * length;
    // Of ux and uy by x, y, z and by y_g.
    const double xx = (1.0 - ux * ux) * length, xy = -ux * uy * length, yy = (1.0 - uy * uy) * length;
    const double x_by_exit = -skew * xx - xy, y_by_exit = -skew * xy - yy;
    const double miss = beta - uy;
    const double miss_by_beta = 1.0 - y_by_exit * y_by_beta;
    const bool near = !(std::abs(miss) > kNear);  // so that what is not finite ends the search
    beta -= miss / miss_by_beta;
    if (!near && i < 60) continue;
    // How ux - alpha goes with a miss.
    const double carry = (x_by_exit * y_by_beta - alpha_by_beta) / miss_by_beta;
    const double share = 1.0 / step;
    out.order = (ux - alpha - carry * miss) * share;
    out.by_local = {(xx + carry * xy) * share, (xy + carry * yy) * share,
                    (-ux * uz - carry * uy * uz) * length * share};
    const double by_exit = x_by_exit + carry * y_by_exit;
    out.by_distance = by_exit * y_by_distance * share;
    out.by_alpha = (by_exit * y_by_alpha - 1.0) * share;
    // Alpha itself goes with beta by alpha_by_beta, which `carry` has.
    out.by_skew = out.by_alpha * beta - y_g * out.by_local.x();
    out.by_bow = out.by_alpha * (root - 1.0);
    break;
  }
  search->beta = beta;
  return out;
}

double StripeModel::Order(const Eigen::Vector2d& pixel, StripeSearch* search) const {
  StripeSearch fresh;
  if (search == nullptr) search = &fresh;
  const Undistorted at = Undistort(pixel, search);
  const double order = FindInFan(centre_ + at.depth * at.direction, search).order;
  search->begun = std::isfinite(order);
  return order;
}

double StripeModel::Order(const Eigen::Vector2d& pixel, bool move_camera, StripeSearch* search,
                          StripeDerivatives* derivatives) const {
  const Undistorted at = Undistort(pixel, search);
  const Eigen::Vector3d place = centre_ + at.depth * at.direction;
  const InFan in_fan = FindInFan(place, search);
  search->begun = std::isfinite(in_fan.order);
  StripeDerivatives& d = *derivatives;

  const Eigen::Vector3d by_place = axes_ * in_fan.by_local;
  const Eigen::Vector3d by_turn = fan_turn_.transpose() * by_place.cross(axes_ * in_fan.local);
  for (int i = 0; i < 3; ++i) {
    d[static_cast<std::size_t>(kStripeFan + kFanOrigin + i)] = -by_place[i];
    d[static_cast<std::size_t>(kStripeFan + kFanTurn + i)] = by_turn[i];
  }
  d[kStripeFan + kFanDistance] = in_fan.by_distance;
  d[kStripeFan + kFanAlpha] = in_fan.by_alpha;
  d[kStripeFan + kFanSkew] = in_fan.by_skew;
  d[kStripeFan + kFanBow] = in_fan.by_bow;
  d[kStripeFan + kFanStep] = -in_fan.order / fan_[kFanStep];

  const double by_height = by_place.dot(at.direction) / at.descent;
  d[kStripePlane] = by_height;
  d[kStripePlane + 1] = by_height * place.x();
  d[kStripePlane + 2] = by_height * place.y();
  if (!move_camera) return in_fan.order;

  // Whatever moves the ray moves the place, which stays on the plane.
  const Eigen::Vector3d by_ray = by_place - by_height * normal_;
  const Eigen::Vector3d in_camera = camera_from_world_ * by_ray;
  const Eigen::Vector3d by_camera_turn = camera_turn_.transpose() * by_ray.cross(place);
  for (int i = 0; i < 3; ++i) {
    d[static_cast<std::size_t>(kStripePose + i)] = by_camera_turn[i];
    d[static_cast<std::size_t>(kStripePose + 3 + i)] = -in_camera[i];
  }
  const auto& k = lens_.value;
  const double by_x = at.depth * (in_camera.x() * at.inverse(0, 0) + in_camera.y() * at.inverse(1, 0));
  const double by_y = at.depth * (in_camera.x() * at.inverse(0, 1) + in_camera.y() * at.inverse(1, 1));
  const double x = at.x, y = at.y, r2 = x * x + y * y, along = -(by_x * x + by_y * y);
  d[kStripeCamera] = -by_x * at.distorted.x() / k[0];
  d[kStripeCamera + 1] = -by_y * at.distorted.y() / k[1];
  d[kStripeCamera + 2] = -by_x / k[0];
  d[kStripeCamera + 3] = -by_y / k[1];
  d[kStripeCamera + 4] = along * r2;
  d[kStripeCamera + 5] = along * r2 * r2;
  d[kStripeCamera + 6] = -(by_x * 2.0 * x * y + by_y * (r2 + 2.0 * y * y));
  d[kStripeCamera + 7] = -(by_x * (r2 + 2.0 * x * x) + by_y * 2.0 * x * y);
  d[kStripeCamera + 8] = along * r2 * r2 * r2;
  return in_fan.order;
}

Eigen::Vector3d StripeModel::Place(const Eigen::Vector2d& pixel) const {
  StripeSearch fresh;
  const Undistorted at = Undistort(pixel, &fresh);
  return centre_ + at.depth * at.direction;
}

StripeModel::Along StripeModel::OrderAlong(const Eigen::Vector2d& pixel) const {
  StripeSearch fresh;
  const Undistorted at = Undistort(pixel, &fresh);
  const InFan in_fan = FindInFan(centre_ + at.depth * at.direction, &fresh);
  const Eigen::Vector3d moved =
      camera_from_world_.transpose() *
      Eigen::Vector3d(at.inverse(0, 0) / lens_.value[0], at.inverse(1, 0) / lens_.value[0], 0.0);
  const Eigen::Vector3d place = at.depth * (moved - normal_.dot(moved) / at.descent * at.direction);
  return {in_fan.order, std::abs((axes_ * in_fan.by_local).dot(place)), std::abs(place.x())};
}

}  // namespace dorsum
