// SPDX-License-Identifier: Apache-2.0
#include "captures/device_description_toml.h"

#include <limits>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

// A description in which no key has its default: every number is moved a little within its range, to a value
// that has no short decimal form.
DeviceDescription OddDevice() {
  const std::string text = DeviceDescriptionToToml(DefaultDevice());
  toml::table table = toml::parse(text);
  const auto move = [](toml::node& node) {
    if (auto* number = node.as_floating_point()) {
      *number = number->get() == 0.0 ? 1.0 / 17.0 : number->get() * (1.0 + 1.0 / 4096.0 + 1e-13);
    } else if (auto* whole = node.as_integer()) {
      *whole = whole->get() + 1;
    } else if (auto* flag = node.as_boolean()) {
      *flag = !flag->get();
    }
  };
  const auto walk = [&move](auto&& self, toml::node& node) -> void {
    if (auto* sub = node.as_table()) {
      for (auto&& [key, value] : *sub) {
        if (key == "resolution_px") {
          *value.as_array()->get(0)->as_integer() = 1280;
          *value.as_array()->get(1)->as_integer() = 1024;
        } else if (key == "format" || key == "fan" || key == "stream_format") {
          *value.as_string() = key == "fan" ? "conical" : key == "format" ? "png" : "raw";
        } else if (key == "white_balance_k") {
          *value.as_integer() = 5600;
        } else if (key == "stream_jpeg_quality") {
          *value.as_integer() = 31;
        } else if (auto* words = value.as_string()) {
          *words = std::string("a \"quoted\" back\\slash\ttab\x01 \xC3\xB6 #") + std::string(key.str());
        } else {
          self(self, value);
        }
      }
    } else if (auto* list = node.as_array()) {
      for (auto&& item : *list) self(self, item);
    } else {
      move(node);
    }
  };
  walk(walk, table);
  std::ostringstream out;
  out << table;
  const auto device = ParseDeviceDescription(out.str(), "odd.toml");
  EXPECT_TRUE(device.ok()) << device.error().message;
  return device.ok() ? *device : DefaultDevice();
}

void CollectKeys(const toml::node& node, const std::string& path, std::set<std::string>* keys) {
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) CollectKeys(value, path + "." + std::string(key.str()), keys);
  } else if (const auto* list = node.as_array();
             list != nullptr && !list->empty() && list->front().is_table()) {
    for (const auto& item : *list) CollectKeys(item, path, keys);
  } else {
    keys->insert(path);
  }
}

std::set<std::string> KeysOf(const toml::table& table) {
  std::set<std::string> keys;
  CollectKeys(table, "", &keys);
  return keys;
}

void ExpectAlike(const toml::node& a, const toml::node& b, const std::string& path) {
  if (const auto* table = a.as_table()) {
    ASSERT_TRUE(b.is_table()) << path;
    for (const auto& [key, value] : *table) {
      const toml::node* other = b.as_table()->get(key);
      ASSERT_NE(other, nullptr) << path << "." << key.str();
      ExpectAlike(value, *other, path + "." + std::string(key.str()));
    }
  } else if (const auto* list = a.as_array()) {
    ASSERT_EQ(list->size(), b.as_array()->size()) << path;
    for (std::size_t i = 0; i < list->size(); ++i) ExpectAlike(*list->get(i), *b.as_array()->get(i), path);
  } else if (a.is_string()) {
    EXPECT_EQ(**a.as_string(), b.value_or(std::string())) << path;
  } else if (a.is_boolean()) {
    EXPECT_EQ(a.value_or(true), b.value_or(false)) << path;
  } else {
    EXPECT_EQ(a.value_or(-1.0), b.value_or(-2.0)) << path;
  }
}

TEST(DeviceDescriptionToml, EveryKeyOfTheShippedFileIsWritten) {
  const auto shipped = KeysOf(toml::parse_file("devices/four-lasers.toml"));
  const auto written = KeysOf(toml::parse(DeviceDescriptionToToml(DefaultDevice())));
  EXPECT_EQ(written, shipped);
  EXPECT_GT(written.size(), 60U);
}

TEST(DeviceDescriptionToml, EveryValueComesBackToTheLastBit) {
  const DeviceDescription odd = OddDevice();
  const toml::table base = toml::parse(DeviceDescriptionToToml(DefaultDevice()));
  const toml::table first = toml::parse(DeviceDescriptionToToml(odd));
  for (const std::string& key : KeysOf(base)) {  // the test itself would miss what it did not move
    const std::string path = key.substr(1);
    if (path.rfind("laser.", 0) == 0 || path.rfind("led.", 0) == 0) continue;
    std::ostringstream a, b;
    a << base.at_path(path);
    b << first.at_path(path);
    EXPECT_NE(a.str(), b.str()) << path;
  }
  const auto again = ParseDeviceDescription(DeviceDescriptionToToml(odd), "odd.toml");
  ASSERT_TRUE(again.ok()) << again.error().message;
  const toml::table second = toml::parse(DeviceDescriptionToToml(*again));
  ExpectAlike(first, second, "");
  EXPECT_EQ(again->camera.focal_length_px, odd.camera.focal_length_px);
  EXPECT_EQ(again->lasers[2].position_mm, odd.lasers[2].position_mm);
  EXPECT_EQ(again->lasers[2].form, FanForm::kConical);
  EXPECT_EQ(again->leds[1].radius_mm, odd.leds[1].radius_mm);
  EXPECT_EQ(again->box_heights_mm, odd.box_heights_mm);
  EXPECT_EQ(again->name, odd.name);
  EXPECT_EQ(again->sensor.bayer, true);
}

TEST(DeviceDescriptionToml, ALaserWithoutAChannelGetsItsNumber) {
  DeviceDescription d = DefaultDevice();
  for (LaserDesign& laser : d.lasers) laser.channel = -1;
  const auto again = ParseDeviceDescription(DeviceDescriptionToToml(d), "d.toml");
  ASSERT_TRUE(again.ok()) << again.error().message;
  for (int k = 0; k < 4; ++k) EXPECT_EQ(again->lasers[static_cast<std::size_t>(k)].channel, k);
}

TEST(DeviceDescriptionToml, TheFileReaderTakesItAndRefusesWhatIsOutOfRange) {
  const TempFolder dir;
  ASSERT_TRUE(WriteFile(dir / "device.toml", DeviceDescriptionToToml(DefaultDevice())).ok());
  EXPECT_TRUE(ReadDeviceDescription(dir / "device.toml").ok());
  DeviceDescription d = DefaultDevice();
  d.grating.lines_per_mm = 9000.0;
  const auto refused = ParseDeviceDescription(DeviceDescriptionToToml(d), "d.toml");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("grating.lines_per_mm"), std::string::npos);
  d = DefaultDevice();
  d.light.laser_irradiance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ParseDeviceDescription(DeviceDescriptionToToml(d), "d.toml").ok());
  EXPECT_FALSE(ParseDeviceDescription("[camera", "d.toml").ok());
}

}  // namespace
}  // namespace dorsum
