// SPDX-License-Identifier: Apache-2.0
#include "captures/device_description.h"

#include <cmath>
#include <numbers>
#include <set>
#include <sstream>
#include <string_view>

#include "base/toml.h"
#include "captures/names.h"

namespace dorsum {
namespace {

std::string Text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string RangeText(double min, double max) { return "from " + Text(min) + " to " + Text(max); }

// Reads typed values of one table, remembers which keys it knows, and keeps the first error of the file.
class Section {
 public:
  Section(const toml::table& table, std::string prefix, std::string file, std::string* error)
      : table_(&table), prefix_(std::move(prefix)), file_(std::move(file)), error_(error) {}

  void Read(std::string_view key, double& value, double min, double max) {
    const toml::node* node = Find(key);
    if (node == nullptr) return;
    if (const auto number = Checked(*node, key, min, max)) value = *number;
  }

  void Read(std::string_view key, int& value, int min, int max) {
    const toml::node* node = Find(key);
    if (node == nullptr) return;
    if (!node->is_integer()) return Fail(key, *node, "a whole number " + RangeText(min, max));
    if (const auto number = Checked(*node, key, min, max)) value = static_cast<int>(*number);
  }

  void Read(std::string_view key, std::string& value) {
    const toml::node* node = Find(key);
    if (node == nullptr) return;
    if (!node->is_string()) return Fail(key, *node, "a text in quotes");
    value = **node->as_string();
  }

  // One of two words; true for the second.
  bool ReadChoice(std::string_view key, const std::string& first, const std::string& second, bool is_second) {
    const toml::node* node = Find(key);
    if (node == nullptr) return is_second;
    const std::string allowed = "\"" + first + "\" or \"" + second + "\"";
    const std::string word = node->value<std::string>().value_or("");
    if (word != first && word != second) Fail(key, *node, allowed);
    return word == second;
  }

  // `count` numbers, or between 1 and -count of them.
  std::vector<double> ReadList(std::string_view key, int count, double min, double max) {
    const toml::node* node = Find(key);
    if (node == nullptr) return {};
    const toml::array* array = node->as_array();
    const std::string wanted = (count > 0 ? "a list of " : "a list of 1 to ") +
                               std::to_string(std::abs(count)) + " numbers " + RangeText(min, max);
    const std::size_t most = static_cast<std::size_t>(std::abs(count));
    if (array == nullptr || array->empty() || array->size() > most || (count > 0 && array->size() != most)) {
      Fail(key, *node, wanted);
      return {};
    }
    std::vector<double> values;
    for (const toml::node& item : *array) {
      const auto number = Checked(item, key, min, max);
      if (!number) return {};
      values.push_back(*number);
    }
    return values;
  }

  template <std::size_t N>
  void Read(std::string_view key, std::array<double, N>& value, double min, double max) {
    const std::vector<double> list = ReadList(key, static_cast<int>(N), min, max);
    if (!list.empty()) std::copy(list.begin(), list.end(), value.begin());
  }

  void Read(std::string_view key, Eigen::Vector3d& value, double min_z, double max_z) {
    const std::vector<double> list = ReadList(key, 3, -5000.0, 5000.0);
    if (list.empty()) return;
    value = {list[0], list[1], list[2]};
    if (!(value.z() >= min_z && value.z() <= max_z)) {
      Fail(key, Text(value.z()), "a point whose height is " + RangeText(min_z, max_z) + " mm");
    }
  }

  // A table of the file; an empty one where there is none.
  Section Sub(std::string_view key) {
    static const toml::table kEmpty;
    const toml::node* node = Find(key);
    if (node != nullptr && !node->is_table()) Fail(key, *node, "a [" + std::string(key) + "] table");
    const toml::table* table = node != nullptr && node->is_table() ? node->as_table() : &kEmpty;
    return Section(*table, prefix_ + std::string(key) + ".", file_, error_);
  }

  // A list of tables, [[key]].
  std::vector<Section> Subs(std::string_view key, int max) {
    std::vector<Section> sections;
    const std::string wanted = "1 to " + std::to_string(max) + " tables [[" + std::string(key) + "]]";
    const toml::node* node = Find(key);
    const toml::array* array = node != nullptr ? node->as_array() : nullptr;
    const std::size_t count = array != nullptr ? array->size() : 0;
    if (count < 1 || count > static_cast<std::size_t>(max) || !array->is_homogeneous<toml::table>()) {
      Fail(key, node != nullptr && array == nullptr ? "no list" : "a list of " + std::to_string(count),
           wanted);
      return sections;
    }
    for (std::size_t i = 0; i < count; ++i) {
      sections.emplace_back(*array->get_as<toml::table>(i),
                            prefix_ + std::string(key) + "[" + std::to_string(i) + "].", file_, error_);
    }
    return sections;
  }

  void RefuseUnknownKeys() {
    for (const auto& [key, node] : *table_) {
      if (!known_.contains(std::string(key.str())) && error_->empty()) {
        std::string names;
        for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
        *error_ = file_ + ": unknown key " + prefix_ + std::string(key.str()) + "; known here: " + names;
      }
    }
  }

  void Fail(std::string_view key, const std::string& value, const std::string& wanted) {
    if (error_->empty()) {
      *error_ = file_ + ": " + prefix_ + std::string(key) + " is " + value + "; it must be " + wanted;
    }
  }

 private:
  const toml::node* Find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
  }

  void Fail(std::string_view key, const toml::node& node, const std::string& wanted) {
    std::ostringstream value;
    node.visit([&value](const auto& n) { value << n; });
    Fail(key, value.str(), wanted);
  }

  std::optional<double> Checked(const toml::node& node, std::string_view key, double min, double max) {
    const bool is_number = node.is_integer() || node.is_floating_point();
    const double number = is_number ? *node.value<double>() : 0.0;
    if (!is_number || !(number >= min && number <= max)) {  // also refuses NaN
      Fail(key, node, "a number " + RangeText(min, max));
      return std::nullopt;
    }
    return number;
  }

  const toml::table* table_;
  std::string prefix_, file_;
  std::string* error_;
  std::set<std::string> known_;
};

void ReadCamera(Section s, CameraDesign& camera) {
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
  s.RefuseUnknownKeys();
}

void ReadSensor(Section s, SensorDesign& sensor) {
  s.Read("full_well_e", sensor.full_well_e, 0, 1e6);
  s.Read("read_noise_e", sensor.read_noise_e, 0, 1000);
  s.Read("gamma", sensor.gamma, 0.3, 4);
  s.Read("black_level", sensor.black_level, 0, 0.2);
  s.Read("psf_sigma_px", sensor.psf_sigma_px, 0, 5);
  s.Read("filter_falloff", sensor.filter_falloff, 0, 0.95);
  s.Read("leak_red", sensor.leak_red, 0, 1);
  s.Read("leak_blue", sensor.leak_blue, 0, 1);
  s.RefuseUnknownKeys();
}

void ReadGrating(Section s, GratingDesign& grating) {
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
               Text(outermost) + ", at most 0.95)");
  }
  s.RefuseUnknownKeys();
}

void ReadLaser(Section s, LaserDesign& laser) {
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

void ReadLed(Section s, LedDesign& led) {
  s.Read("position_mm", led.position_mm, 100, 5000);
  s.Read("radius_mm", led.radius_mm, 0.5, 1000);
  s.Read("irradiance", led.irradiance, 0, 4);
  s.Read("channel", led.channel, 0, 63);
  s.RefuseUnknownKeys();
}

void ReadSmallSections(Section& root, DeviceDescription& d) {
  Section light = root.Sub("light");
  light.Read("laser_irradiance", d.light.laser_irradiance, 0.01, 100);
  light.Read("ambient_laser", d.light.ambient_laser, 0, 1);
  light.Read("ambient_led", d.light.ambient_led, 0, 1);
  light.RefuseUnknownKeys();

  Section board = root.Sub("board");
  board.Read("columns", d.board.columns, 3, 60);
  board.Read("rows", d.board.rows, 3, 60);
  board.Read("square_mm", d.board.square_mm, 1, 200);
  board.RefuseUnknownKeys();

  Section calibration = root.Sub("calibration");
  calibration.Read("object_height_mm", d.calibration_object_height_mm, 5, 500);
  const std::vector<double> boxes = calibration.ReadList("box_heights_mm", -32, 1, 500);
  if (!boxes.empty()) d.box_heights_mm = boxes;
  calibration.Read("working_heights_mm", d.working_heights_mm, -50, 500);
  if (d.working_heights_mm[0] >= d.working_heights_mm[1]) {
    calibration.Fail("working_heights_mm", "not ascending", "the lower height, then the upper one");
  }
  calibration.RefuseUnknownKeys();

  Section controller = root.Sub("controller");
  controller.Read("port", d.controller_port);
  controller.Read("baud", d.controller_baud, 300, 4000000);
  controller.RefuseUnknownKeys();
}

void ReadImperfections(Section& root, DeviceDescription& d) {
  Section mounting = root.Sub("mounting");
  mounting.Read("camera_position_mm", d.mounting.camera_position_mm, 0, 50);
  mounting.Read("camera_angle_deg", d.mounting.camera_angle_deg, 0, 10);
  mounting.Read("laser_position_mm", d.mounting.laser_position_mm, 0, 20);
  mounting.Read("laser_angle_deg", d.mounting.laser_angle_deg, 0, 10);
  mounting.Read("grating_turn_deg", d.mounting.grating_turn_deg, 0, 5);
  mounting.Read("focal_length_share", d.mounting.focal_length_share, 0, 0.1);
  mounting.Read("principal_point_px", d.mounting.principal_point_px, 0, 200);
  mounting.RefuseUnknownKeys();

  Section speckle = root.Sub("speckle");
  speckle.Read("contrast", d.speckle.contrast, 0, 1);
  speckle.Read("correlation_px", d.speckle.correlation_px, 0, 10);
  speckle.RefuseUnknownKeys();

  Section skin = root.Sub("skin");
  skin.Read("line_blur_mm", d.skin.line_blur_mm, 0, 5);
  skin.Read("scatter_share", d.skin.scatter_share, 0, 1);
  skin.Read("scatter_sigma_mm", d.skin.scatter_sigma_mm, 0.01, 20);
  skin.RefuseUnknownKeys();
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
  std::string error;
  Section root(table, "", path.string(), &error);
  DeviceDescription d;
  root.Read("name", d.name);
  ReadCamera(root.Sub("camera"), d.camera);
  ReadSensor(root.Sub("sensor"), d.sensor);
  ReadGrating(root.Sub("grating"), d.grating);
  for (const Section& s : root.Subs("laser", kMaxLasers)) {
    ReadLaser(s, d.lasers.emplace_back());
    if (d.lasers.back().channel < 0) d.lasers.back().channel = static_cast<int>(d.lasers.size()) - 1;
  }
  for (const Section& s : root.Subs("led", 8)) ReadLed(s, d.leds.emplace_back());
  ReadSmallSections(root, d);
  ReadImperfections(root, d);
  root.RefuseUnknownKeys();
  if (!error.empty()) return BadInput(error);
  return d;
}

}  // namespace dorsum
