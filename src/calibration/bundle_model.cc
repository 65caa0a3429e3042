// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_model.h"

#include "calibration/turn.h"

namespace dorsum {
LensParameters LensFromCamera(const Camera& c) {
  return {{c.fx, c.fy, c.cx, c.cy, c.distortion[0], c.distortion[1], c.distortion[2], c.distortion[3],
           c.distortion[4]}};
}

PoseParameters PoseFromRigid(const Rigid3& rigid) {
  PoseParameters pose;
  pose.start = rigid.rotation;
  for (int i = 0; i < 3; ++i) pose.value[static_cast<std::size_t>(3 + i)] = rigid.translation[i];
  return pose;
}

FanParameters FanFromGeometry(const DiffractedFan& fan) {
  FanParameters p;
  p.start << fan.a, fan.b, fan.n;
  for (int i = 0; i < 3; ++i) p.value[static_cast<std::size_t>(kFanOrigin + i)] = fan.origin[i];
  p.value[kFanDistance] = fan.fan_distance_mm;
  p.value[kFanAlpha] = std::sin(fan.tilt);
  p.value[kFanSkew] = fan.turn;
  p.value[kFanBow] = EffectiveBow(fan);
  p.value[kFanStep] = fan.step;
  return p;
}

Camera CameraFromParameters(const LensParameters& lens, const PoseParameters& camera_from_world, int width,
                            int height) {
  const auto& k = lens.value;
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.fx = k[0];
  camera.fy = k[1];
  camera.cx = k[2];
  camera.cy = k[3];
  for (std::size_t i = 0; i < 5; ++i) camera.distortion[i] = k[4 + i];
  camera.camera_from_world = RigidFromPose(camera_from_world);
  return camera;
}

Rigid3 RigidFromPose(const PoseParameters& pose) {
  return {pose.start * TurnMatrix({pose.value[0], pose.value[1], pose.value[2]}),
          {pose.value[3], pose.value[4], pose.value[5]}};
}

DiffractedFan GeometryFromFan(const FanParameters& p) {
  const Eigen::Matrix3d axes =
      TurnMatrix({p.value[kFanTurn], p.value[kFanTurn + 1], p.value[kFanTurn + 2]}) * p.start;
  DiffractedFan fan;
  fan.origin = {p.value[0], p.value[1], p.value[2]};
  fan.a = axes.col(0);
  fan.b = axes.col(1);
  fan.n = axes.col(2);
  fan.fan_distance_mm = p.value[kFanDistance];
  fan.tilt = std::asin(p.value[kFanAlpha]);
  fan.turn = p.value[kFanSkew];
  fan.bow = p.value[kFanBow];
  fan.step = p.value[kFanStep];
  fan.form = FanForm::kGeneral;
  return fan;
}

}  // namespace dorsum
