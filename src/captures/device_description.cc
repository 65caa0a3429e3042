// SPDX-License-Identifier: Apache-2.0
#include "captures/device_description.h"

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/toml.h"
#include "captures/device_description_toml.h"
#include "captures/device_section.h"
#include "captures/names.h"

namespace dorsum {
namespace {

void ReadCameraSettings(DeviceSection& s, CameraDesign& camera) {
  const bool raw = s.ReadChoice("stream_format", "mjpeg", "raw", camera.stream_format == "raw");
  camera.stream_format = raw ? "raw" : "mjpeg";
  for (const auto& [key, exposure] : {std::pair{"laser_exposure_s", &camera.laser_exposure_s},
                                      {"led_exposure_s", &camera.led_exposure_s}}) {
    s.Read(key, *exposure, 0, 10);
    if (*exposure != 0.0 && *exposure < 0.0001) {
      s.Fail(key, DeviceSection::Text(*exposure), "0 (left as it is) or from 0.0001 to 10");
    }
  }
  if ((camera.laser_exposure_s == 0.0) != (camera.led_exposure_s == 0.0)) {
    s.Fail(camera.led_exposure_s == 0.0 ? "led_exposure_s" : "laser_exposure_s", "0",
           "given when the other exposure is");
  }
  s.Read("gain", camera.gain, -1, 65535);
  s.Read("focus", camera.focus, -1, 65535);
  s.Read("white_balance_k", camera.white_balance_k, 0, 20000);
  if (camera.white_balance_k != 0 && camera.white_balance_k < 1000) {
    s.Fail("white_balance_k", std::to_string(camera.white_balance_k),
           "0 (left as it is) or from 1000 to 20000");
  }
}

void ReadCamera(DeviceSection s, CameraDesign& camera) {
  s.Read("source", camera.source);
  std::array<double, 2> size = {double(camera.width), double(camera.height)};
  s.Read("resolution_px", size, 64, 10000);
  camera.width = static_cast<int>(size[0]);
  camera.height = static_cast<int>(size[1]);
  if (camera.width != size[0] || camera.height != size[1])
    s.Fail("resolution_px", "not whole", "two whole numbers");
  s.Read("focal_length_px", camera.focal_length_px, 50, 100000);
  s.Read("distortion", camera.distortion, -2, 2);
  s.Read("position_mm", camera.position_mm, 100, 3000);
  s.Read("look_at_mm", camera.look_at_mm, -100, 90);
  camera.format = s.ReadChoice("format", "jpeg", "png", camera.format == "png") ? "png" : "jpeg";
  s.Read("jpeg_quality", camera.jpeg_quality, 50, 100);
  s.Read("stream_jpeg_quality", camera.stream_jpeg_quality, 0, 100);
  if (camera.stream_jpeg_quality != 0 && camera.stream_jpeg_quality < 30) {
    s.Fail("stream_jpeg_quality", std::to_string(camera.stream_jpeg_quality), "0 (none) or from 30 to 100");
  }
  ReadCameraSettings(s, camera);
  s.RefuseUnknownKeys();
}

void ReadSensor(DeviceSection s, SensorDesign& sensor) {
  s.Read("full_well_e", sensor.full_well_e, 0, 1e6);
  s.Read("read_noise_e", sensor.read_noise_e, 0, 1000);
  s.Read("gamma", sensor.gamma, 0.3, 4);
  s.Read("black_level", sensor.black_level, 0, 0.2);
  s.Read("psf_sigma_px", sensor.psf_sigma_px, 0, 5);
  s.Read("filter_falloff", sensor.filter_falloff, 0, 0.95);
  s.Read("leak_red", sensor.leak_red, 0, 1);
  s.Read("leak_blue", sensor.leak_blue, 0, 1);
  s.Read("bayer", sensor.bayer);
  s.RefuseUnknownKeys();
}

void ReadGrating(DeviceSection s, GratingDesign& grating) {
  s.Read("lines_per_mm", grating.lines_per_mm, 1, 5000);
  s.Read("wavelength_nm", grating.wavelength_nm, 300, 1100);
  s.Read("turn_deg", grating.turn_deg, 0, 80);
  s.Read("orders", grating.orders, 1, 60);
  s.Read("first_order_efficiency", grating.first_order_efficiency, 0.01, 1);
  s.Read("last_order_efficiency", grating.last_order_efficiency, 0.001, 1);
  s.Read("efficiency_spread", grating.efficiency_spread, 0, 0.3);
  const double outermost = grating.orders * grating.Step();
  if (outermost > 0.95) {
    s.Fail("orders", std::to_string(grating.orders),
           "small enough that the outermost order leaves the grating (orders * wavelength * lines * "
           "cos(turn) is " +
               DeviceSection::Text(outermost) + ", at most 0.95)");
  }
  s.RefuseUnknownKeys();
}

void ReadLaser(DeviceSection s, LaserDesign& laser) {
  s.Read("position_mm", laser.position_mm, 100, 3000);
  s.Read("half_angle_deg", laser.half_angle_deg, 1, 60);
  s.Read("relative_power", laser.relative_power, 0.01, 10);
  s.Read("tilt_deg", laser.tilt_deg, -30, 30);
  s.Read("fan_distance_mm", laser.fan_distance_mm, 0, 100);
  s.Read("line_sigma_mrad", laser.line_sigma_mrad, 0.05, 20);
  const bool conical = s.ReadChoice("fan", "flat", "conical", laser.form == FanForm::kConical);
  laser.form = conical ? FanForm::kConical : FanForm::kFlat;
  s.Read("channel", laser.channel, 0, 63);
  s.RefuseUnknownKeys();
}

void ReadLed(DeviceSection s, LedDesign& led) {
  s.Read("position_mm", led.position_mm, 100, 5000);
  s.Read("radius_mm", led.radius_mm, 0.5, 1000);
  s.Read("irradiance", led.irradiance, 0, 4);
  s.Read("channel", led.channel, 0, 63);
  s.RefuseUnknownKeys();
}

void ReadSmallSections(DeviceSection& root, DeviceDescription& d) {
  DeviceSection light = root.Sub("light");
  light.Read("laser_irradiance", d.light.laser_irradiance, 0.01, 100);
  light.Read("ambient_laser", d.light.ambient_laser, 0, 1);
  light.Read("ambient_led", d.light.ambient_led, 0, 1);
  light.RefuseUnknownKeys();

  DeviceSection board = root.Sub("board");
  board.Read("columns", d.board.columns, 3, 60);
  board.Read("rows", d.board.rows, 3, 60);
  board.Read("square_mm", d.board.square_mm, 1, 200);
  board.RefuseUnknownKeys();

  DeviceSection calibration = root.Sub("calibration");
  calibration.Read("object_height_mm", d.calibration_object_height_mm, 5, 500);
  const std::vector<double> boxes = calibration.ReadList("box_heights_mm", -32, 1, 500);
  if (!boxes.empty()) d.box_heights_mm = boxes;
  calibration.Read("working_heights_mm", d.working_heights_mm, -50, 500);
  if (d.working_heights_mm[0] >= d.working_heights_mm[1]) {
    calibration.Fail("working_heights_mm", "not ascending", "the lower height, then the upper one");
  }
  calibration.RefuseUnknownKeys();

  DeviceSection controller = root.Sub("controller");
  controller.Read("port", d.controller_port);
  controller.Read("baud", d.controller_baud, 300, 4000000);
  controller.RefuseUnknownKeys();
}

void ReadImperfections(DeviceSection& root, DeviceDescription& d) {
  DeviceSection mounting = root.Sub("mounting");
  mounting.Read("camera_position_mm", d.mounting.camera_position_mm, 0, 50);
  mounting.Read("camera_angle_deg", d.mounting.camera_angle_deg, 0, 10);
  mounting.Read("laser_position_mm", d.mounting.laser_position_mm, 0, 20);
  mounting.Read("laser_angle_deg", d.mounting.laser_angle_deg, 0, 10);
  mounting.Read("grating_turn_deg", d.mounting.grating_turn_deg, 0, 5);
  mounting.Read("focal_length_share", d.mounting.focal_length_share, 0, 0.1);
  mounting.Read("principal_point_px", d.mounting.principal_point_px, 0, 200);
  mounting.RefuseUnknownKeys();

  DeviceSection speckle = root.Sub("speckle");
  speckle.Read("contrast", d.speckle.contrast, 0, 1);
  speckle.Read("correlation_px", d.speckle.correlation_px, 0, 10);
  speckle.RefuseUnknownKeys();

  DeviceSection skin = root.Sub("skin");
  skin.Read("line_blur_mm", d.skin.line_blur_mm, 0, 5);
  skin.Read("scatter_share", d.skin.scatter_share, 0, 1);
  skin.Read("scatter_sigma_mm", d.skin.scatter_sigma_mm, 0.01, 20);
  skin.RefuseUnknownKeys();
}

Result<DeviceDescription> DescriptionIn(const toml::table& table, const std::string& where) {
  std::string error;
  DeviceSection root(table, "", where, &error);
  DeviceDescription d;
  root.Read("name", d.name);
  ReadCamera(root.Sub("camera"), d.camera);
  ReadSensor(root.Sub("sensor"), d.sensor);
  ReadGrating(root.Sub("grating"), d.grating);
  for (const DeviceSection& s : root.Subs("laser", kMaxLasers)) {
    ReadLaser(s, d.lasers.emplace_back());
    if (d.lasers.back().channel < 0) d.lasers.back().channel = static_cast<int>(d.lasers.size()) - 1;
  }
  for (const DeviceSection& s : root.Subs("led", 8)) ReadLed(s, d.leds.emplace_back());
  ReadSmallSections(root, d);
  ReadImperfections(root, d);
  root.RefuseUnknownKeys();
  if (!error.empty()) return BadInput(error);
  return d;
}

}  // namespace

double GratingDesign::Step() const {
  return wavelength_nm * 1e-6 * lines_per_mm * std::cos(turn_deg * std::numbers::pi / 180.0);
}

DeviceDescription DefaultDevice() {
  DeviceDescription d;
  // Neighbouring stripes lie step * 395 mm = 14.86 mm apart on the backplane. Lasers three quarters of that
  // apart fill the gaps evenly: their combs are offset by -1/4 each.
  for (int k = 0; k < 4; ++k) {
    LaserDesign laser;
    laser.position_mm = {11.15 * (k - 1), 0.0, 395.0};
    laser.channel = k;
    if (k == 3) laser.relative_power = 0.5;  // the document's weak fourth laser (chapter 6)
    d.lasers.push_back(laser);
  }
  for (const auto& [x, y] : {std::pair{-430.0, 330.0}, {440.0, 310.0}, {0.0, -520.0}}) {
    LedDesign led;
    led.position_mm = {x, y, 940.0};
    d.leds.push_back(led);
  }
  return d;
}

Result<DeviceDescription> ReadDeviceDescription(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const toml::table table, ReadTomlFile(path));
  return DescriptionIn(table, path.string());
}

Result<DeviceDescription> ParseDeviceDescription(std::string_view text, const std::string& where) {
  try {
    return DescriptionIn(toml::parse(text), where);
  } catch (const toml::parse_error& e) {
    return BadInput(where + ", line " + std::to_string(e.source().begin.line) + ": " +
                    std::string(e.description()));
  }
}

}  // namespace dorsum
