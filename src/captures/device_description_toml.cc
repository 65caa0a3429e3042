// SPDX-License-Identifier: Apache-2.0
#include "captures/device_description_toml.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

namespace dorsum {
namespace {

std::string Text(double value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  std::string text(digits, end.ptr);
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string Text(int value) { return std::to_string(value); }
std::string Text(bool value) { return value ? "true" : "false"; }

std::string Text(const std::string& value) {
  std::string out = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04X", static_cast<unsigned>(byte));
      out += escape;
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string Text(std::span<const double> values) {
  std::string out = "[";
  for (const double value : values) out += (out.size() > 1 ? ", " : "") + Text(value);
  return out + "]";
}

std::string Text(const std::array<int, 2>& pair) { return "[" + Text(pair[0]) + ", " + Text(pair[1]) + "]"; }

std::string Text(const Eigen::Vector3d& v) { return Text(std::span<const double>(v.data(), 3)); }

// Grows by one line for each key.
class Writer {
 public:
  void Comment(const std::string& text) { out_ += "# " + text + "\n"; }
  void Table(const std::string& header) { out_ += "\n" + header + "\n"; }
  template <class T>
  void Key(const std::string& key, const T& value) {
    out_ += key + " = " + Text(value) + "\n";
  }
  std::string Finish() { return std::move(out_); }

 private:
  std::string out_;
};

void WriteCamera(const CameraDesign& camera, Writer& w) {
  w.Table("[camera]");
  w.Key("source", camera.source);
  w.Key("resolution_px", std::array<int, 2>{camera.width, camera.height});
  w.Key("focal_length_px", camera.focal_length_px);
  w.Key("distortion", camera.distortion);
  w.Key("position_mm", camera.position_mm);
  w.Key("look_at_mm", camera.look_at_mm);
  w.Key("format", camera.format);
  w.Key("jpeg_quality", camera.jpeg_quality);
  w.Key("stream_jpeg_quality", camera.stream_jpeg_quality);
  w.Key("stream_format", camera.stream_format);
  w.Key("laser_exposure_s", camera.laser_exposure_s);
  w.Key("led_exposure_s", camera.led_exposure_s);
  w.Key("gain", camera.gain);
  w.Key("focus", camera.focus);
  w.Key("white_balance_k", camera.white_balance_k);
}

void WriteSensor(const SensorDesign& sensor, Writer& w) {
  w.Table("[sensor]");
  w.Key("full_well_e", sensor.full_well_e);
  w.Key("read_noise_e", sensor.read_noise_e);
  w.Key("gamma", sensor.gamma);
  w.Key("black_level", sensor.black_level);
  w.Key("psf_sigma_px", sensor.psf_sigma_px);
  w.Key("filter_falloff", sensor.filter_falloff);
  w.Key("leak_red", sensor.leak_red);
  w.Key("leak_blue", sensor.leak_blue);
  w.Key("bayer", sensor.bayer);
}

void WriteController(const DeviceDescription& d, Writer& w) {
  w.Table("[controller]");
  w.Key("port", d.controller_port);
  w.Key("baud", d.controller_baud);
}

void WriteGrating(const GratingDesign& grating, Writer& w) {
  w.Table("[grating]");
  w.Key("lines_per_mm", grating.lines_per_mm);
  w.Key("wavelength_nm", grating.wavelength_nm);
  w.Key("turn_deg", grating.turn_deg);
  w.Key("orders", grating.orders);
  w.Key("first_order_efficiency", grating.first_order_efficiency);
  w.Key("last_order_efficiency", grating.last_order_efficiency);
  w.Key("efficiency_spread", grating.efficiency_spread);
}

void WriteLaser(const LaserDesign& laser, int number, Writer& w) {
  w.Table("[[laser]]");
  w.Key("position_mm", laser.position_mm);
  w.Key("half_angle_deg", laser.half_angle_deg);
  w.Key("relative_power", laser.relative_power);
  w.Key("tilt_deg", laser.tilt_deg);
  w.Key("fan_distance_mm", laser.fan_distance_mm);
  w.Key("line_sigma_mrad", laser.line_sigma_mrad);
  w.Key("fan", std::string(laser.form == FanForm::kConical ? "conical" : "flat"));
  w.Key("channel", laser.channel < 0 ? number : laser.channel);
}

void WriteLed(const LedDesign& led, Writer& w) {
  w.Table("[[led]]");
  w.Key("position_mm", led.position_mm);
  w.Key("radius_mm", led.radius_mm);
  w.Key("irradiance", led.irradiance);
  w.Key("channel", led.channel);
}

void WriteSurroundings(const DeviceDescription& d, Writer& w) {
  w.Table("[light]");
  w.Key("laser_irradiance", d.light.laser_irradiance);
  w.Key("ambient_laser", d.light.ambient_laser);
  w.Key("ambient_led", d.light.ambient_led);

  w.Table("[board]");
  w.Key("columns", d.board.columns);
  w.Key("rows", d.board.rows);
  w.Key("square_mm", d.board.square_mm);

  w.Table("[calibration]");
  w.Key("object_height_mm", d.calibration_object_height_mm);
  w.Key("box_heights_mm", d.box_heights_mm);
  w.Key("working_heights_mm", d.working_heights_mm);
}

void WriteImperfections(const DeviceDescription& d, Writer& w) {
  w.Table("[mounting]");
  w.Key("camera_position_mm", d.mounting.camera_position_mm);
  w.Key("camera_angle_deg", d.mounting.camera_angle_deg);
  w.Key("laser_position_mm", d.mounting.laser_position_mm);
  w.Key("laser_angle_deg", d.mounting.laser_angle_deg);
  w.Key("grating_turn_deg", d.mounting.grating_turn_deg);
  w.Key("focal_length_share", d.mounting.focal_length_share);
  w.Key("principal_point_px", d.mounting.principal_point_px);

  w.Table("[speckle]");
  w.Key("contrast", d.speckle.contrast);
  w.Key("correlation_px", d.speckle.correlation_px);

  w.Table("[skin]");
  w.Key("line_blur_mm", d.skin.line_blur_mm);
  w.Key("scatter_share", d.skin.scatter_share);
  w.Key("scatter_sigma_mm", d.skin.scatter_sigma_mm);
}

}  // namespace

std::string DeviceDescriptionToToml(const DeviceDescription& d) {
  Writer w;
  w.Comment(
      "Millimetres in the frame of the design: z up from the backplane, x across the stripes. Light is in");
  w.Comment(
      "units of what brings a white surface in mid-picture to full scale. What each key means: "
      "docs/formats.md.");
  w.Key("name", d.name);
  WriteCamera(d.camera, w);
  WriteSensor(d.sensor, w);
  WriteController(d, w);
  WriteGrating(d.grating, w);
  for (std::size_t k = 0; k < d.lasers.size(); ++k) WriteLaser(d.lasers[k], static_cast<int>(k), w);
  for (const LedDesign& led : d.leds) WriteLed(led, w);
  WriteSurroundings(d, w);
  WriteImperfections(d, w);
  return w.Finish();
}

}  // namespace dorsum
