// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>

#include <Eigen/Core>

#include "base/random.h"

namespace dorsum {

enum class Side { kLeft, kRight };

constexpr double Radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// How a hand lies, palm down, on the plane z = 0. Angles in radians, written for a right hand: positive turns
// in the plane go towards its thumb. Arrays of four run from the index to the little finger.
struct HandPose {
  double yaw = 0.0;  // of the whole hand about z, counter-clockwise from above
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // mm: the midpoint between wrist crease and middle tip
  std::array<double, 3> spread = {Radians(8), Radians(7),
                                  Radians(9)};  // between neighbouring fingers, [4, 12] deg
  double middle_deviation = 0.0;                // of the middle finger from the hand's axis
  std::array<double, 4> pip_flexion = {Radians(7), Radians(7), Radians(7), Radians(8)};  // [0, 15] deg
  std::array<double, 4> dip_flexion = {Radians(3), Radians(3), Radians(3), Radians(3)};  // [0, 8] deg
  double thumb_abduction = Radians(44);  // of the first metacarpal from the hand's axis
  double thumb_mcp_bend = Radians(12);   // each link turns back towards the fingers by this
  double thumb_ip_bend = Radians(6);
  double thumb_roll = Radians(35);  // tilt of the thumb's nail away from the fingers
  double wrist_deviation = 0.0;     // of the forearm from the hand's axis, about z
};

// A hand put down naturally, as often as asked: yaw +-8 deg, centre +-8 mm, fingers apart.
HandPose SampleHandPose(Rng& rng);

}  // namespace dorsum
