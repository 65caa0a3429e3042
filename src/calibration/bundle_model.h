// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/light_sheet.h"

namespace dorsum {

// What the bundle adjustment moves, as plain numbers. Rotations are small turns
// about a fixed start, so that no parameter is ever near a wrap.
inline constexpr int kLensSize = 9;      // fx fy cx cy (px), k1 k2 p1 p2 k3
inline constexpr int kPoseSize = 6;      // turn (rad), translation (mm)
inline constexpr int kFanSize = 11;      // see FanParameter
inline constexpr int kPlaneSize = 3;     // height at the origin (mm), slopes along x and y
inline constexpr int kBoardBowSize = 3;  // sag of the board's corners along x^2, xy and y^2, mm

enum FanParameter {
  kFanOrigin = 0,  // 3, mm
  kFanTurn = 3,    // 3, rad, about the world's axes
  kFanDistance = 6,
  kFanAlpha = 7,  // sine of the tilt
  kFanSkew = 8,   // `turn` of DiffractedFan
  kFanBow = 9,
  kFanStep = 10,
};

struct LensParameters {
  std::array<double, kLensSize> value{};
};
struct PoseParameters {
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
  std::array<double, kPoseSize> value{};
};
struct FanParameters {
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();  // columns a, b, n
  std::array<double, kFanSize> value{};
};

LensParameters LensFromCamera(const Camera& camera);
PoseParameters PoseFromRigid(const Rigid3& rigid);
FanParameters FanFromGeometry(const DiffractedFan& fan);  // always of the general form
Camera CameraFromParameters(const LensParameters& lens, const PoseParameters& camera_from_world, int width,
                            int height);
Rigid3 RigidFromPose(const PoseParameters& pose);
DiffractedFan GeometryFromFan(const FanParameters& p);

}  // namespace dorsum
