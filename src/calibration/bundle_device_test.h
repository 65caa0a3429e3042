// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "calibration/bundle_problem.h"
#include "geometry/calibration.h"

namespace dorsum {

// A small exact device for the bundle's tests: an oblique camera with distortion, and lasers whose fans lean.
inline Camera BundleCamera() {
  Camera camera;
  camera.width = 800;
  camera.height = 600;
  camera.fx = 1000.0;
  camera.fy = 1003.0;
  camera.cx = 405.0;
  camera.cy = 296.0;
  camera.distortion = {-0.1, 0.05, 3e-4, -2e-4, 0.01};
  const Eigen::Vector3d position(-110.0, 3.0, 385.0);
  const Eigen::Vector3d z = (Eigen::Vector3d(10.0, 0.0, 0.0) - position).normalized();
  const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - z.x() * z).normalized();
  camera.camera_from_world.rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * position);
  return camera;
}

inline DiffractedFan BundleFan(double x, double tilt, FanForm form) {
  DiffractedFan fan;
  fan.origin = {x, 1.5, 394.0};
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.015, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  fan.a = turn * Eigen::Vector3d::UnitX();
  fan.b = turn * -Eigen::Vector3d::UnitY();
  fan.n = turn * -Eigen::Vector3d::UnitZ();
  fan.fan_distance_mm = 14.0;
  fan.tilt = tilt;
  fan.step = 0.0376;
  fan.form = form;
  return fan;
}

// Column in which a row sees the sheet of an order at height z; none outside the image.
inline std::optional<double> SheetColumn(const Camera& camera, const DiffractedFan& fan, int order, double v,
                                         double z) {
  LaserGeometry laser;
  laser.fan = fan;
  double u = 0.5 * camera.width;
  for (int i = 0; i < 40; ++i) {
    const auto here = OrderAtHeight(camera, laser, SheetModel::kCone, {u, v}, z);
    const auto there = OrderAtHeight(camera, laser, SheetModel::kCone, {u + 0.01, v}, z);
    if (!here || !there) return std::nullopt;
    const double change = std::clamp((*here - order) / ((*there - *here) / 0.01), -200.0, 200.0);
    u -= change;
    if (std::abs(change) < 1e-11) break;
  }
  return u >= 0.0 && u <= camera.width - 1 ? std::optional(u) : std::nullopt;
}

// Exact stripe points of one fan on a plane; `source` is the picture that they came from.
inline void AddStripes(const Camera& camera, const DiffractedFan& fan, int laser, int plane, double z,
                       int source, BundleData* data, int every_rows = 40) {
  for (int order = -10; order <= 10; ++order) {
    for (int v = 10; v < camera.height; v += every_rows) {
      const auto u = SheetColumn(camera, fan, order, v, z);
      if (!u) continue;
      SheetPoint p;
      p.laser = laser;
      p.source = source;
      p.plane = plane;
      p.order = order;
      p.u = *u;
      p.v = v;
      p.sd_px = 0.02;
      p.peak = 100.0;
      p.orders_per_px = 0.025;
      p.mm_per_px = 0.38;
      data->points.push_back(p);
    }
  }
}

struct BundleFixture {
  Camera camera = BundleCamera();
  std::vector<DiffractedFan> fans = {BundleFan(-5.0, 0.05, FanForm::kFlat),
                                     BundleFan(6.0, -0.03, FanForm::kConical)};
  BundleData data;
  BundleState truth;

  // Pictures 0 and 1 show the backplane, 2 the calibration object, 3 a box; 4 to 7 the same of the second
  // laser.
  explicit BundleFixture(double object_mm = 50.0, double box_mm = 25.0, double board_sag_mm = 0.0) {
    data.planes = {{"the backplane", 0.0, 0.0},
                   {"the calibration object", 50.0, 0.01},
                   {"the box of 25.0 mm", 25.0, 0.02}};
    for (int k = 0; k < 2; ++k) {
      const DiffractedFan& fan = fans[static_cast<std::size_t>(k)];
      AddStripes(camera, fan, k, 0, 0.0, 4 * k, &data);
      AddStripes(camera, fan, k, 0, 0.0, 4 * k + 1, &data);
      AddStripes(camera, fan, k, 1, object_mm, 4 * k + 2, &data);
      AddStripes(camera, fan, k, 2, box_mm, 4 * k + 3, &data);
    }
    for (int r = 0; r < 5; ++r) {
      for (int c = 0; c < 7; ++c) data.board_points.emplace_back(15.0 * (c - 3), -15.0 * (r - 2), 0.0);
    }
    for (int view = 0; view < 9; ++view) AddBoard(view, object_mm, board_sag_mm);
    truth.width = camera.width;
    truth.height = camera.height;
    truth.lens = LensFromCamera(camera);
    truth.camera_from_world = PoseFromRigid(camera.camera_from_world);
    truth.planes = {{0.0, 0.0, 0.0}, {object_mm, 0.0, 0.0}, {box_mm, 0.0, 0.0}};
    for (const DiffractedFan& fan : fans) truth.fans.push_back(FanFromGeometry(fan));
  }

  // A start that is off by what a first estimate is.
  BundleState Start() const {
    BundleState start = truth;
    for (std::size_t i = 1; i < start.planes.size(); ++i) start.planes[i][0] = data.planes[i].given_mm;
    for (FanParameters& fan : start.fans) {
      fan.value[kFanOrigin] += 0.4;
      fan.value[kFanOrigin + 2] -= 1.5;
      fan.value[kFanDistance] = 18.0;
      fan.value[kFanAlpha] -= 0.002;
      fan.value[kFanBow] = 0.0;
      fan.value[kFanStep] *= 1.003;
    }
    start.lens.value[0] += 2.0;
    start.lens.value[4] += 0.005;
    start.camera_from_world.value[5] += 0.5;
    return start;
  }

 private:
  // Views 0 and 1 lie on the backplane, 2 and 3 on the object, the others are tilted.
  void AddBoard(int view, double object_mm, double sag_mm) {
    Rigid3 pose;
    if (view > 3) {
      pose.rotation = Eigen::AngleAxisd(0.4, Eigen::Vector3d(std::cos(1.3 * view), std::sin(1.3 * view), 0.0))
                          .toRotationMatrix();
      pose.translation = {8.0 * (view - 6), 5.0 * (6 - view), 30.0};
    } else if (view > 0) {
      pose.translation = {4.0 * view, -6.0, view > 1 ? object_mm : 0.0};
    }
    BoardView board{"board" + std::to_string(view), {}, view > 3 ? -1 : view > 1 ? 1 : 0};
    for (const Eigen::Vector3d& flat : data.board_points) {
      Eigen::Vector3d p = flat;
      p.z() += sag_mm * std::pow(p.x() / 45.0, 2);
      board.corners.push_back(Project(camera, pose * p));
    }
    data.boards.push_back(board);
    truth.world_from_board.push_back(PoseFromRigid(pose));
  }
};

}  // namespace dorsum
