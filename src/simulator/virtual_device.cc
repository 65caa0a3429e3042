// SPDX-License-Identifier: Apache-2.0
#include "simulator/virtual_device.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "base/random.h"
#include "captures/designed_geometry.h"

namespace dorsum {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

Eigen::Vector3d NormalVector(Rng& rng, double sigma) {
  const double x = rng.Normal(), y = rng.Normal(), z = rng.Normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

Eigen::Matrix3d Rotation(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation_vector / angle).toRotationMatrix();
}

Camera BuildCamera(const DeviceDescription& d, Rng rng) {
  const CameraDesign& design = d.camera;
  const MountingDesign& mounting = d.mounting;
  Camera camera;
  camera.width = design.width;
  camera.height = design.height;
  camera.fx = design.focal_length_px * (1.0 + mounting.focal_length_share * rng.Normal());
  camera.fy = camera.fx * (1.0 + 0.1 * mounting.focal_length_share * rng.Normal());
  camera.cx = 0.5 * (design.width - 1) + mounting.principal_point_px * rng.Normal();
  camera.cy = 0.5 * (design.height - 1) + mounting.principal_point_px * rng.Normal();
  camera.distortion = design.distortion;
  const Eigen::Vector3d position = design.position_mm + NormalVector(rng, mounting.camera_position_mm);
  Rigid3 error;
  error.rotation = Rotation(NormalVector(rng, mounting.camera_angle_deg * kRadian));
  camera.camera_from_world = error * LookAt(position, design.look_at_mm);
  return camera;
}

// Efficiencies fall like a Gaussian from the first order to the last, as a grating's single slit makes them.
std::vector<double> DrawEfficiencies(const GratingDesign& grating, Rng& rng) {
  std::vector<double> efficiency;
  const double fall = std::log(grating.first_order_efficiency / grating.last_order_efficiency);
  for (int m = -grating.orders; m <= grating.orders; ++m) {
    const double share = grating.orders > 1 ? (std::abs(m) - 1.0) / (grating.orders - 1.0) : 0.0;
    const double noise = std::max(0.1, 1.0 + grating.efficiency_spread * rng.Normal());
    efficiency.push_back(m == 0 ? 1.0
                                : grating.first_order_efficiency * std::exp(-fall * share * share) * noise);
  }
  return efficiency;
}

VirtualLaser BuildLaser(const DeviceDescription& d, const LaserDesign& design, Rng rng) {
  const MountingDesign& mounting = d.mounting;
  VirtualLaser laser;
  laser.position_error_mm = NormalVector(rng, mounting.laser_position_mm);
  laser.rotation_error_rad = NormalVector(rng, mounting.laser_angle_deg * kRadian);
  const Eigen::Matrix3d turn = Rotation(laser.rotation_error_rad);
  DiffractedFan& fan = laser.fan;
  fan.origin = design.position_mm + laser.position_error_mm;
  fan.a = turn * Eigen::Vector3d::UnitX();
  fan.b = turn * -Eigen::Vector3d::UnitY();
  fan.n = turn * -Eigen::Vector3d::UnitZ();
  fan.fan_distance_mm = design.fan_distance_mm * (1.0 + 0.03 * rng.Normal());
  fan.tilt = (design.tilt_deg + mounting.laser_angle_deg * rng.Normal()) * kRadian;
  fan.form = design.form;
  GratingDesign grating = d.grating;
  grating.turn_deg += mounting.grating_turn_deg * rng.Normal();
  fan.step = grating.Step();
  laser.efficiency = DrawEfficiencies(grating, rng);
  laser.sigma_alpha = design.line_sigma_mrad * 1e-3 * (1.0 + 0.03 * rng.Normal());
  laser.half_angle = design.half_angle_deg * kRadian * (1.0 + 0.01 * rng.Normal());
  laser.relative_power = design.relative_power * (1.0 + 0.02 * rng.Normal());
  // So that the middle of the central stripe gets laser_irradiance * relative_power at the designed height
  // (LaserIrradiance: power * gamma * cos / (r (r + s)), straight below both cosines are 1).
  const double height = design.position_mm.z();
  laser.power = d.light.laser_irradiance * laser.relative_power * height * (height + design.fan_distance_mm);
  return laser;
}

VirtualLed BuildLed(const LedDesign& design) {
  VirtualLed led;
  led.position = design.position_mm;
  led.radius_mm = design.radius_mm;
  // Straight to the origin, where the backplane sees it at cosine z / d.
  const double d2 = design.position_mm.squaredNorm();
  led.intensity = design.irradiance * d2 / (design.position_mm.z() / std::sqrt(d2));
  return led;
}

// World frame of DESIGN §2 as a motion of the design's frame within the backplane.
Rigid3 WorldFromDesign(const Camera& camera_in_design, const DiffractedFan& fan, double board_y) {
  const StripePointOnPlane at = CentralStripeAt(fan, 0.0, board_y);
  Eigen::Vector3d x = at.direction.cross(Eigen::Vector3d::UnitZ());
  const double du = Project(camera_in_design, at.point + x).x() - Project(camera_in_design, at.point).x();
  if (du < 0.0) x = -x;
  Rigid3 world_from_design;
  world_from_design.rotation << x.transpose(), Eigen::Vector3d::UnitZ().cross(x).transpose(),
      Eigen::RowVector3d::UnitZ();
  world_from_design.translation = -(world_from_design.rotation * at.point);
  return world_from_design;
}

void MoveFan(const Rigid3& world_from_design, VirtualLaser& laser) {
  DiffractedFan& fan = laser.fan;
  fan.origin = world_from_design * fan.origin;
  fan.a = world_from_design.rotation * fan.a;
  fan.b = world_from_design.rotation * fan.b;
  fan.n = world_from_design.rotation * fan.n;
  if (fan.a.x() <
      0.0) {  // orders count towards growing x: the same light with both grating axes turned round
    fan.a = -fan.a;
    fan.b = -fan.b;
    fan.tilt = -fan.tilt;
    laser.efficiency = {laser.efficiency.rbegin(), laser.efficiency.rend()};
  }
}

}  // namespace

StripePointOnPlane CentralStripeAt(const DiffractedFan& fan, double z, double y) {
  const Plane plane{Eigen::Vector3d::UnitZ(), z};
  const auto at = [&](double beta) {
    const auto ray = DiffractedRay(fan, 0, beta);
    const auto t = ray ? Intersect(*ray, plane) : std::nullopt;
    if (!t) throw std::logic_error("CentralStripeAt: the central order does not reach the plane");
    return ray->At(*t);
  };
  // Secant steps on y(beta), which is nearly tan(asin(beta)) times the height.
  double beta0 = 0.0, beta1 = 0.01;
  Eigen::Vector3d p0 = at(beta0), p1 = at(beta1);
  for (int i = 0; i < 50 && std::abs(p1.y() - y) > 1e-11 && p1.y() != p0.y(); ++i) {
    const double next = beta1 + (y - p1.y()) * (beta1 - beta0) / (p1.y() - p0.y());
    beta0 = beta1;
    p0 = p1;
    beta1 = std::clamp(next, -0.9, 0.9);
    p1 = at(beta1);
  }
  StripePointOnPlane result{p1, (at(beta1 + 1e-5) - at(beta1 - 1e-5)).normalized()};
  if (result.direction.y() < 0.0) result.direction = -result.direction;
  return result;
}

VirtualDevice BuildVirtualDevice(const DeviceDescription& description, std::uint64_t seed) {
  VirtualDevice device;
  device.description = description;
  device.seed = seed;
  device.camera = BuildCamera(description, Rng(NamedSeed("camera", seed)));
  for (std::size_t k = 0; k < description.lasers.size(); ++k) {
    Rng rng(NamedSeed("laser" + std::to_string(k), seed));
    device.lasers.push_back(BuildLaser(description, description.lasers[k], rng));
  }
  for (const LedDesign& led : description.leds) device.leds.push_back(BuildLed(led));

  // The operator centres the first board on the stripe, yet puts it down anywhere along it.
  const double board_y = 2.0 * Rng(NamedSeed("board", seed)).Normal();
  const DiffractedFan& first = device.lasers[static_cast<std::size_t>(WorldLaser(device))].fan;
  const Rigid3 world_from_design = WorldFromDesign(device.camera, first, board_y);
  device.camera.camera_from_world = device.camera.camera_from_world * world_from_design.Inverse();
  for (VirtualLaser& laser : device.lasers) MoveFan(world_from_design, laser);
  for (VirtualLed& led : device.leds) led.position = world_from_design * led.position;
  return device;
}

}  // namespace dorsum
