// SPDX-License-Identifier: Apache-2.0
#include "captures/setup.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Setup Usual() {
  Setup s;
  s.board_columns = 9;
  s.board_rows = 6;
  s.square_mm = 20.0;
  s.calibration_object_height_mm = 40.0;
  s.box_heights_mm = {13.5, 27.0};
  s.grating_lines_per_mm = 100.0;
  s.wavelength_nm = 532.0;
  s.width = 640;
  s.height = 480;
  return s;
}

class SetupTest : public ::testing::Test {
 protected:
  std::string MessageOf(const std::string& text) {
    EXPECT_TRUE(WriteFile(folder_ / "setup.json", text).ok());
    const auto setup = ReadSetup(folder_.path());
    if (setup.ok()) return "(no error)";
    EXPECT_EQ(setup.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(setup.error().message, HasSubstr("setup.json"));
    return setup.error().message;
  }
  std::string MessageOfChanged(const std::function<void(Json&)>& change) {
    Json json = SetupToJson(Usual());
    change(json);
    return MessageOf(json.dump());
  }
  TempFolder folder_;
};

TEST_F(SetupTest, ComesBackAsWritten) {
  ASSERT_TRUE(WriteJson(folder_ / "setup.json", SetupToJson(Usual())).ok());
  const auto s = ReadSetup(folder_.path());
  ASSERT_TRUE(s.ok()) << s.error().message;
  EXPECT_EQ(SetupToJson(*s), SetupToJson(Usual()));
}

TEST_F(SetupTest, AMissingFileSaysWhatItIsFor) {
  EXPECT_THAT(ReadSetup(folder_.path()).error().message,
              AllOf(HasSubstr("no setup.json"), HasSubstr("chessboard")));
}

TEST_F(SetupTest, WhatIsNotJsonIsRefused) {
  for (const char* text : {"", "{", "[]", "3", "null", "\"setup\"", "{}"})
    EXPECT_NE(MessageOf(text), "(no error)");
  EXPECT_THAT(MessageOf("{\"wavelength_nm\": NaN}"), HasSubstr("NaN"));
}

TEST_F(SetupTest, EachMissingKeyIsNamed) {
  for (const char* key : {"chessboard", "calibration_object_height_mm", "box_heights_mm",
                          "grating_lines_per_mm", "wavelength_nm", "camera_resolution"}) {
    EXPECT_THAT(MessageOfChanged([&](Json& j) { j.erase(key); }), HasSubstr(key));
  }
  for (const char* key : {"inner_corners", "square_mm"}) {
    EXPECT_THAT(MessageOfChanged([&](Json& j) { j["chessboard"].erase(key); }), HasSubstr(key));
  }
}

TEST_F(SetupTest, WrongTypesAndAbsurdValuesAreNamed) {
  const Json absurd = {{"chessboard", 5},
                       {"calibration_object_height_mm", -40.0},
                       {"box_heights_mm", {13.5, -1.0}},
                       {"grating_lines_per_mm", "100"},
                       {"wavelength_nm", 53.2},
                       {"camera_resolution", {640, 480, 3}}};
  for (const auto& [key, value] : absurd.items()) {
    EXPECT_THAT(MessageOfChanged([&, k = key, v = value](Json& j) { j[k] = v; }), HasSubstr(key));
  }
  for (const Json& size : {Json{0, 480}, Json{640.5, 480}, Json{640, 1e9}}) {
    EXPECT_THAT(MessageOfChanged([&](Json& j) { j["camera_resolution"] = size; }),
                HasSubstr("camera_resolution"));
  }
  for (const Json& corners : {Json{9.5, 6}, Json{2, 6}, Json{9, 1000}, Json{9}, Json(9)}) {
    EXPECT_THAT(MessageOfChanged([&](Json& j) { j["chessboard"]["inner_corners"] = corners; }),
                HasSubstr("inner_corners"));
  }
  EXPECT_THAT(MessageOfChanged([](Json& j) { j["chessboard"]["square_mm"] = 0.0; }), HasSubstr("square_mm"));
}

TEST_F(SetupTest, NoBoxesIsAllowed) {
  EXPECT_EQ(MessageOfChanged([](Json& j) { j["box_heights_mm"] = Json::array(); }), "(no error)");
}

}  // namespace
}  // namespace dorsum
