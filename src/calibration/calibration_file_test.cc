// SPDX-License-Identifier: Apache-2.0
#include "calibration/calibration_file.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/random.h"
#include "base/temp_folder_test.h"
#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

Calibration Whole() {
  Calibration c;
  c.device = TestDevice();
  c.device.camera.distortion = {-0.1, 1.0 / 3.0, 1e-3, -2e-3, 0.05};
  c.device.max_height_mm = 75.5;
  for (LaserGeometry& laser : c.device.lasers) laser = TestLaser(laser.laser, laser.grating.x(), -2, 2);
  LaserGeometry& laser = c.device.lasers[1];
  laser.fan = DiffractedFan{.origin = {60.0, 0.1, 300.0},
                            .fan_distance_mm = 4.5,
                            .tilt = 0.04,
                            .step = 0.0271,
                            .form = FanForm::kConical};
  laser.reference.push_back(
      {.order = -1, .middle_v = 240.5, .half_v = 200.0, .u = {1, 2, 3, 4}, .peak = {5, 6, 7}});
  laser.correction.c = {0.1, 0.02, 3e-3, 4e-4, 5e-5, 6e-6};
  laser.residual_mm = 0.123;
  c.background = std::string("\x89PNG\0\xff", 6);
  c.parts = {{"camera", Grade::kDoubtful, "so so", {{"views", 12.0, ""}, {"rms", 0.1 + 0.2, "px"}}}};
  c.warnings = {"one", "two"};
  c.sources = {{"chess00.jpg", "ab12"}};
  c.version = "0.1.0";
  return c;
}

std::string MessageOf(const Json& json) {
  const auto c = CalibrationFromJson(json, "calibration.json");
  if (c.ok()) return "(no error)";
  EXPECT_EQ(c.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(c.error().message, HasSubstr("calibration.json"));
  return c.error().message;
}

std::string MessageOfChanged(const std::function<void(Json&)>& change) {
  Json json = CalibrationToJson(Whole());
  change(json);
  return MessageOf(json);
}

TEST(CalibrationFile, KeepsEveryFormOfFan) {
  for (const FanForm form : {FanForm::kFlat, FanForm::kConical, FanForm::kGeneral}) {
    Calibration c = Whole();
    DiffractedFan fan = c.device.lasers[1].fan.value_or(DiffractedFan{});
    fan.form = form;
    fan.bow = 0.0123;
    fan.turn = -1.0 / 300.0;
    c.device.lasers[1].fan = fan;
    const auto read = CalibrationFromJson(CalibrationToJson(c), "calibration.json");
    ASSERT_TRUE(read.ok()) << read.error().message;
    const DiffractedFan back = read->device.lasers[1].fan.value_or(DiffractedFan{});
    EXPECT_EQ(back.form, form);
    EXPECT_EQ(back.turn, fan.turn);
    EXPECT_EQ(EffectiveBow(back), EffectiveBow(fan));
  }
}

TEST(CalibrationFile, AFanThatMakesNoSenseIsNamed) {
  const auto cone = [](Json& json) -> Json& { return json["lasers"][1]["cone"]; };
  EXPECT_THAT(MessageOfChanged([&](Json& j) { cone(j)["form"] = "round"; }),
              HasSubstr("flat, conical or general"));
  EXPECT_THAT(MessageOfChanged([&](Json& j) { cone(j)["bow"] = 7.0; }), HasSubstr("bow"));
  EXPECT_THAT(MessageOfChanged([&](Json& j) { cone(j)["turn_rad"] = nullptr; }), HasSubstr("turn_rad"));
}

TEST(CalibrationFile, TheRoundTripIsExact) {
  const TempFolder folder;
  const Calibration written = Whole();
  ASSERT_TRUE(WriteCalibration(folder / "calibration.json", written).ok());
  const auto read = ReadCalibration(folder / "calibration.json");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(CalibrationToJson(*read), CalibrationToJson(written));
  EXPECT_EQ(read->background, written.background);
  EXPECT_EQ(read->method, "classic");
  EXPECT_EQ(read->parts[0].grade, Grade::kDoubtful);
  EXPECT_EQ(read->parts[0].figures[1].value, 0.1 + 0.2);
  const LaserGeometry &a = read->device.lasers[1], &b = written.device.lasers[1];
  EXPECT_EQ(a.planes[3].plane.normal, b.planes[3].plane.normal);
  EXPECT_EQ(a.planes[3].plane.offset, b.planes[3].plane.offset);
  EXPECT_EQ(a.correction.c, b.correction.c);
  ASSERT_TRUE(a.fan.has_value());
  const DiffractedFan fan = a.fan.value_or(DiffractedFan{}), expected = b.fan.value_or(DiffractedFan{});
  EXPECT_EQ(fan.form, FanForm::kConical);
  EXPECT_EQ(fan.step, expected.step);
  EXPECT_EQ(a.reference[0].u, b.reference[0].u);
  EXPECT_FALSE(read->device.lasers[0].fan.has_value());
  EXPECT_EQ(read->device.camera.distortion, written.device.camera.distortion);
  EXPECT_EQ(read->device.camera.camera_from_world.rotation, written.device.camera.camera_from_world.rotation);
}

TEST(CalibrationFile, EachMissingKeyIsNamed) {
  const Json whole = CalibrationToJson(Whole());
  for (const auto& [key, value] : whole.items()) {
    EXPECT_NE(MessageOfChanged([&, k = key](Json& j) { j.erase(k); }), "(no error)") << key;
  }
  for (const auto& [key, value] : whole["camera"].items()) {
    EXPECT_THAT(MessageOfChanged([&, k = key](Json& j) { j["camera"].erase(k); }), HasSubstr(key));
  }
  for (const auto& [key, value] : whole["lasers"][1].items()) {
    if (key == "cone") continue;
    EXPECT_THAT(MessageOfChanged([&, k = key](Json& j) { j["lasers"][1].erase(k); }), HasSubstr(key));
  }
  for (const char* part : {"cone", "correction"}) {
    for (const auto& [key, value] : whole["lasers"][1][part].items()) {
      EXPECT_THAT(MessageOfChanged([&, k = key](Json& j) { j["lasers"][1][part].erase(k); }), HasSubstr(key));
    }
  }
  for (const char* list : {"planes", "reference_stripes"}) {
    for (const auto& [key, value] : whole["lasers"][1][list][0].items()) {
      EXPECT_THAT(MessageOfChanged([&, k = key](Json& j) { j["lasers"][1][list][0].erase(k); }),
                  HasSubstr(key));
    }
  }
}

TEST(CalibrationFile, ValuesThatCannotBeAreRefused) {
  const std::vector<std::pair<const char*, Json>> damage = {
      {"/camera/width", 0},
      {"/camera/camera_matrix/0", -800.0},
      {"/camera/camera_matrix/0", nullptr},
      {"/camera/camera_from_world/rotation/0", 0.9},
      {"/camera/camera_from_world/rotation/0", -1.0},  // a mirror image
      {"/camera/camera_from_world/translation_mm/2", -400.0},
      {"/working_volume_mm/0", 90.0},
      {"/lasers", Json::array()},
      {"/lasers/1/laser", 0},
      {"/lasers/1/laser", 8},
      {"/lasers/1", 5},
      {"/lasers/1/planes/2/order", 7},
      {"/lasers/1/planes/2/normal/0", 0.5},
      {"/lasers/1/planes/2/offset_mm", "far"},
      {"/lasers/0/planes", Json::array()},  // laser 0 has no cone either
      {"/lasers/1/cone/a/0", 0.5},
      {"/lasers/1/cone/form", "round"},
      {"/lasers/1/cone/step", 0.0},
      {"/lasers/1/correction/polynomial", {1, 2}},
      {"/lasers/1/residual_mm", -1.0},
      {"/lasers/1/reference_stripes/0/half_v_px", 0.0},
      {"/parts/0/grade", "splendid"},
      {"/parts/0/figures/0/value", nullptr},
      {"/made_from/0/sha256", 5},
      {"/background_image_base64", "?"},
      {"/schema", "dorsum/height"},
      {"/version", 2},
      {"/method", 5}};
  for (const auto& [where, value] : damage) {
    EXPECT_NE(MessageOfChanged([&, w = where, v = value](Json& j) { j[Json::json_pointer(w)] = v; }),
              "(no error)")
        << where << " = " << value;
  }
  EXPECT_NE(MessageOf(Json::array()), "(no error)");
  EXPECT_NE(MessageOf(Json(nullptr)), "(no error)");
}

TEST(CalibrationFile, NotANumberIsRefusedOnReading) {
  const TempFolder folder;
  std::string text = CalibrationToJson(Whole()).dump(1);
  const std::size_t at = text.find("0.0271");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 6, "NaN");
  ASSERT_TRUE(WriteFile(folder / "calibration.json", text).ok());
  EXPECT_THAT(ReadCalibration(folder / "calibration.json").error().message, HasSubstr("NaN"));
  // A NaN that a program wrote becomes null.
  Calibration c = Whole();
  c.device.lasers[0].residual_mm = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(WriteCalibration(folder / "calibration.json", c).ok());
  EXPECT_THAT(ReadCalibration(folder / "calibration.json").error().message, HasSubstr("residual_mm"));
}

TEST(CalibrationFile, TruncatedAndMissingFilesAreNamed) {
  const TempFolder folder;
  const std::string text = CalibrationToJson(Whole()).dump(1);
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, text.size() / 3, text.size() - 1}) {
    ASSERT_TRUE(WriteFile(folder / "calibration.json", text.substr(0, n)).ok());
    const auto c = ReadCalibration(folder / "calibration.json");
    ASSERT_FALSE(c.ok()) << n;
    EXPECT_THAT(c.error().message, HasSubstr("calibration.json"));
  }
  EXPECT_FALSE(ReadCalibration(folder / "none.json").ok());
  EXPECT_FALSE(ReadCalibration(folder.path()).ok());
}

TEST(CalibrationFile, RandomDamageIsReadOrRefusedButNeverThrows) {
  const std::string text = CalibrationToJson(Whole()).dump(1);
  Rng rng(17);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = text;
    const std::size_t at = rng.Next() % damaged.size();
    damaged[at] = static_cast<char>(i % 3 == 0 ? rng.Next() : 32 + rng.Next() % 95);
    EXPECT_NO_THROW({
      const Json json = Json::parse(damaged, nullptr, false);
      refused += json.is_discarded() || !CalibrationFromJson(json, "calibration.json").ok() ? 1 : 0;
    }) << "byte "
       << at;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace dorsum
