// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

#include "calibration/bundle_model.h"

namespace dorsum {

// Where the search for a stripe point's place begins: as it was found the last time, or nowhere yet.
struct StripeSearch {
  double x = 0.0, y = 0.0;  // in the undistorted picture of focal length 1
  double beta = 0.0;        // in the fan
  bool begun = false;
};

// Derivatives of an order by lens, camera_from_world, fan and plane, in this order.
inline constexpr int kStripeCamera = 0, kStripePose = kLensSize, kStripeFan = kStripePose + kPoseSize,
                     kStripePlane = kStripeFan + kFanSize, kStripeSize = kStripePlane + kPlaneSize;
using StripeDerivatives = std::array<double, kStripeSize>;

// The order that a fan has where a pixel sees a plane of known height, with its derivatives by all
// parameters: pixel, undistorted place, ray, place on the plane, order, each by its own few equations; the
// two that have no formula (undistortion, and the ray of the fan that reaches a place) by Newton's method and
// the implicit function theorem. One object for one state: what its points share is worked out once.
class StripeModel {
 public:
  StripeModel(const LensParameters& lens, const PoseParameters& camera_from_world, const FanParameters& fan,
              const std::array<double, kPlaneSize>& plane);

  // The order as a real number; not finite where the fan does not reach.
  double Order(const Eigen::Vector2d& pixel, StripeSearch* search = nullptr) const;
  // And its derivatives; `move_camera`: also those by lens and pose, which are left alone otherwise.
  double Order(const Eigen::Vector2d& pixel, bool move_camera, StripeSearch* search,
               StripeDerivatives* derivatives) const;
  // The place on the plane, world, mm.
  Eigen::Vector3d Place(const Eigen::Vector2d& pixel) const;

  // An order and how it and the place's x change along the row.
  struct Along {
    double order = 0.0, orders_per_px = 0.0, mm_per_px = 0.0;
  };
  Along OrderAlong(const Eigen::Vector2d& pixel) const;

 private:
  struct Undistorted;
  struct InFan;

  Undistorted Undistort(const Eigen::Vector2d& pixel, StripeSearch* search) const;
  InFan FindInFan(const Eigen::Vector3d& place, StripeSearch* search) const;

  LensParameters lens_;
  std::array<double, kPlaneSize> plane_;
  std::array<double, kFanSize> fan_;
  Eigen::Matrix3d camera_from_world_, camera_turn_;  // rotation, and how it grows, in the world
  Eigen::Vector3d centre_;                           // of the camera, world
  Eigen::Vector3d normal_;                           // of the plane, with z = 1
  Eigen::Matrix3d axes_, fan_turn_;                  // the same of the fan
};

}  // namespace dorsum
