// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_device.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace dorsum {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

Camera CameraOf(const CameraDesign& design) {
  Camera camera;
  camera.width = design.width;
  camera.height = design.height;
  camera.fx = camera.fy = design.focal_length_px;
  camera.cx = 0.5 * (design.width - 1);
  camera.cy = 0.5 * (design.height - 1);
  camera.distortion = design.distortion;
  // Its rows as level along x as looking at the target allows.
  const Eigen::Vector3d z = (design.look_at_mm - design.position_mm).normalized();
  const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - z.x() * z).normalized();
  Rigid3& pose = camera.camera_from_world;
  pose.rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
  pose.translation = -(pose.rotation * design.position_mm);
  return camera;
}

DesignedLaser LaserOf(const DeviceDescription& d, const LaserDesign& design) {
  DesignedLaser laser;
  laser.fan.origin = design.position_mm;
  laser.fan.fan_distance_mm = design.fan_distance_mm;
  laser.fan.tilt = design.tilt_deg * kRadian;
  laser.fan.step = d.grating.Step();
  laser.fan.form = design.form;
  for (int m = 0; m <= d.grating.orders; ++m) laser.efficiency.push_back(DescribedEfficiency(d.grating, m));
  laser.sigma_alpha = 1e-3 * design.line_sigma_mrad;
  laser.half_angle = design.half_angle_deg * kRadian;
  const double height = design.position_mm.z();
  laser.power = d.light.laser_irradiance * design.relative_power * height * (height + design.fan_distance_mm);
  return laser;
}

}  // namespace

Eigen::AlignedBox2d SeenRectangle(const Camera& camera, double z) {
  const Plane plane{Eigen::Vector3d::UnitZ(), z};
  const double w = camera.width - 1.0, h = camera.height - 1.0;
  std::array<Eigen::Vector2d, 4> corners;  // upper left, upper right, lower left, lower right
  for (int i = 0; i < 4; ++i) {
    const Ray ray = CastRay(camera, {i % 2 * w, i / 2 * h});  // NOLINT(bugprone-integer-division)
    const auto t = Intersect(ray, plane);
    if (!t || ray.direction.z() >= 0.0) return {};
    corners[static_cast<std::size_t>(i)] = ray.At(*t).head<2>();
  }
  // x grows with u, y with -v.
  const auto& [a, b, c, d] = corners;
  return {Eigen::Vector2d(std::max(a.x(), c.x()), std::max(c.y(), d.y())),
          Eigen::Vector2d(std::min(b.x(), d.x()), std::min(a.y(), b.y()))};
}

double FittingSquare(const DesignedDevice& device) {
  const BoardDesign& board = device.description.board;
  const Eigen::AlignedBox2d seen =
      SeenRectangle(device.camera, device.description.calibration_object_height_mm);
  if (seen.isEmpty()) return board.square_mm;
  const Eigen::Vector2d squares(board.columns + 1.0, board.rows + 1.0);
  const double fits = 0.8 * seen.sizes().cwiseQuotient(squares).minCoeff();
  return fits >= board.square_mm ? board.square_mm : std::max(1.0, std::floor(fits));
}

double DescribedEfficiency(const GratingDesign& grating, int order) {
  if (order == 0) return 1.0;
  const double fall = std::log(grating.first_order_efficiency / grating.last_order_efficiency);
  const double share = grating.orders > 1 ? (std::abs(order) - 1.0) / (grating.orders - 1.0) : 0.0;
  return grating.first_order_efficiency * std::exp(-fall * share * share);
}

SlitGrating GratingOf(const GratingDesign& grating) {
  return {grating.lines_per_mm, grating.wavelength_nm, grating.turn_deg * kRadian};
}

Result<DesignedDevice> LayOutDevice(const DeviceDescription& description, const Eigen::Vector2d& hand_mm) {
  DesignedDevice device{description, CameraOf(description.camera), {}, {}};
  const auto& [low, high] = description.working_heights_mm;
  if (description.camera.position_mm.z() < high + 20.0) {
    return BadInput("the camera stands " + std::to_string(std::lround(description.camera.position_mm.z())) +
                    " mm high, which is not above the working volume; raise it to " +
                    std::to_string(std::lround(high + 20.0)) + " mm or more");
  }
  for (const LaserDesign& laser : description.lasers) {
    if (laser.position_mm.z() < high + 20.0) {
      return BadInput("a laser's grating stands " + std::to_string(std::lround(laser.position_mm.z())) +
                      " mm high, which is not above the working volume; raise it to " +
                      std::to_string(std::lround(high + 20.0)) + " mm or more");
    }
    device.lasers.push_back(LaserOf(description, laser));
  }
  const Eigen::AlignedBox2d seen =
      SeenRectangle(device.camera, low).intersection(SeenRectangle(device.camera, high));
  if (seen.isEmpty()) {
    return BadInput(
        "the camera sees no part of the backplane through the whole working volume; bring it nearer above "
        "the place that it looks at, or shorten its focal length");
  }
  device.hand = {seen.center() - 0.5 * hand_mm, seen.center() + 0.5 * hand_mm};
  return device;
}

}  // namespace dorsum
