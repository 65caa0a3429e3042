// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <vector>

#include "simulator/truth_files.h"

namespace dorsum {
namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;

Json Numbers(const Eigen::VectorXd& v) { return std::vector<double>(v.data(), v.data() + v.size()); }

Json Rows(const Eigen::Matrix3d& m) {
  return {Numbers(m.row(0).transpose()), Numbers(m.row(1).transpose()), Numbers(m.row(2).transpose())};
}

Json CameraToJson(const Camera& camera) {
  Eigen::Matrix3d k;
  k << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0;
  Json json;
  json["width"] = camera.width;
  json["height"] = camera.height;
  json["K"] = Rows(k);
  json["dist"] = camera.distortion;
  json["R"] = Rows(camera.camera_from_world.rotation);
  json["t"] = Numbers(camera.camera_from_world.translation);
  json["center"] = Numbers(camera.Center());
  return json;
}

Json LaserToJson(const VirtualLaser& laser) {
  const DiffractedFan& fan = laser.fan;
  Json json;
  json["origin"] = Numbers(fan.origin);
  json["a"] = Numbers(fan.a);
  json["b"] = Numbers(fan.b);
  json["n"] = Numbers(fan.n);
  json["s"] = fan.fan_distance_mm;
  json["alpha_in"] = IncomingAlpha(fan, 0.0);
  json["D"] = fan.step;
  json["M"] = laser.Orders();
  json["eff"] = laser.efficiency;
  json["sigma_alpha"] = laser.sigma_alpha;
  json["half_angle_deg"] = laser.half_angle * kDegree;
  json["power"] = laser.power;
  json["relative_power"] = laser.relative_power;
  for (const DirtySpot& spot : laser.dirt) {
    json["dirt"].push_back(
        {{"beta", spot.beta}, {"half_width", spot.half_width}, {"transmission", spot.transmission}});
  }
  json["fan_model"] = fan.form == FanForm::kConical ? "conical" : "flat";
  json["mount"]["position_error"] = Numbers(laser.position_error_mm);
  json["mount"]["rotvec_deg"] = Numbers(laser.rotation_error_rad * kDegree);
  return json;
}

}  // namespace

Json DeviceToJson(const VirtualDevice& device) {
  const DeviceDescription& d = device.description;
  Json json;
  json["seed"] = device.seed;
  json["profile"] = d.name;
  json["units"] = "mm";
  json["camera"] = CameraToJson(device.camera);
  json["optics"] = {
      {"psf_sigma", d.sensor.psf_sigma_px}, {"cos4", 1.0}, {"filter_falloff", d.sensor.filter_falloff}};
  json["sensor"] = {{"full_well", d.sensor.full_well_e}, {"read_noise", d.sensor.read_noise_e},
                    {"gamma", d.sensor.gamma},           {"leak_r", d.sensor.leak_red},
                    {"leak_b", d.sensor.leak_blue},      {"black", d.sensor.black_level},
                    {"bayer", d.sensor.bayer},           {"jpeg_roundtrip", d.camera.stream_jpeg_quality}};
  json["speckle"] = {{"contrast", d.speckle.contrast}, {"corr_px", d.speckle.correlation_px}};
  json["ambient"] = {{"laser_images", d.light.ambient_laser}, {"led_images", d.light.ambient_led}};
  for (const VirtualLed& led : device.leds) {
    json["led"]["lights"].push_back(
        {{"pos", Numbers(led.position)}, {"radius", led.radius_mm}, {"intensity", led.intensity}});
  }
  for (const VirtualLaser& laser : device.lasers) json["lasers"].push_back(LaserToJson(laser));
  json["grating"] = {{"lines_per_mm", d.grating.lines_per_mm},
                     {"wavelength_mm", d.grating.wavelength_nm * 1e-6},
                     {"projection_factor", std::cos(d.grating.turn_deg / kDegree)}};
  return json;
}

}  // namespace dorsum
