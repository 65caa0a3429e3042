// SPDX-License-Identifier: Apache-2.0
#include "simulator/simulate.h"

#include <atomic>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/json.h"
#include "captures/image_file.h"
#include "captures/names.h"
#include "captures/setup.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSmallDevice = R"(
name = "small"
[camera]
resolution_px = [240, 180]
focal_length_px = 312.0
format = "png"
[[laser]]
[[laser]]
position_mm = [11.0, 0.0, 395.0]
[[led]]
irradiance = 0.8
[mounting]
principal_point_px = 1.0
[calibration]
box_heights_mm = [10.0, 25.5]
)";

class SimulateTest : public ::testing::Test {
 protected:
  SimulateTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    dir_ = fs::path(::testing::TempDir()) / (std::string("simulate_") + info->name());
    fs::remove_all(dir_);
    fs::create_directories(dir_);
    options_.device_path = dir_ / "device.toml";
    EXPECT_TRUE(WriteFile(options_.device_path, kSmallDevice).ok());
    options_.calibration = false;
  }
  ~SimulateTest() override { fs::remove_all(dir_); }

  // Everything beside the device file, as relative paths.
  std::set<std::string> Files() const {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(dir_)) {
      if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), dir_).string());
    }
    files.erase("device.toml");
    return files;
  }

  fs::path dir_;
  SimulateOptions options_;
};

TEST_F(SimulateTest, WritesTheFoldersOfTheDesign) {
  options_.calibration = true;
  options_.scenes = {"box13.5_r0"};
  const auto report = Simulate(options_, dir_ / "out", Context{});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->captures, 1);
  const fs::path calibration = dir_ / "out" / "calibration";
  std::vector<std::string> images = {kFirstEstimatesName, kBgNoHandName, LaserBgName(Distance::kFurther),
                                     LaserBgName(Distance::kCloser)};
  for (int i = 0; i < kChessViews; ++i) images.push_back(ChessName(i));
  for (int k = 0; k < 2; ++k) {
    images.push_back(StripesBgName(k));
    for (const Distance d : {Distance::kFurther, Distance::kCloser}) {
      images.push_back(LaserCalName(k, d));
      images.push_back(LaserChessName(k, d));
    }
  }
  for (const char* height : {"heights/h10.0/", "heights/h25.5/"}) {
    for (const std::string& name : {std::string(kBgHandName), StripesHandName(0), StripesHandName(1)}) {
      images.push_back(height + name);
    }
  }
  for (const std::string& name : images) {
    EXPECT_TRUE(ReadImage(calibration / (name + ".png"), cv::Size(240, 180)).ok()) << name;
  }
  const auto setup = ReadSetup(calibration);
  ASSERT_TRUE(setup.ok()) << setup.error().message;
  EXPECT_EQ(setup->box_heights_mm, (std::vector<double>{10.0, 25.5}));
  std::set<std::string> expected = {"out/calibration/setup.json", "out/truth/device.json"};
  for (const std::string& name : images) expected.insert("out/calibration/" + name + ".png");
  for (const char* name : {"bgHand", "stripesHand0", "stripesHand1"}) {
    expected.insert(std::string("out/captures/box13.5_r0/") + name + ".png");
  }
  for (const char* name :
       {"height.png", "material.png", "reference.ply", "stripes0.csv.gz", "stripes1.csv.gz"}) {
    expected.insert(std::string("out/truth/box13.5_r0/") + name);
  }
  EXPECT_EQ(Files(), expected);
}

TEST_F(SimulateTest, SameSeedSameFilesAtOneAndTwoThreads) {
  options_.scenes = {"box13.5", "cylinder10+dust0+moved1+after"};
  Context one, two;
  one.threads = 1;
  two.threads = 2;
  ASSERT_TRUE(Simulate(options_, dir_ / "a", one).ok());
  ASSERT_TRUE(Simulate(options_, dir_ / "b", two).ok());
  options_.seed = "another";
  ASSERT_TRUE(Simulate(options_, dir_ / "c", two).ok());
  int compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(dir_ / "a")) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = fs::relative(entry.path(), dir_ / "a");
    EXPECT_EQ(*ReadFile(entry.path()), *ReadFile(dir_ / "b" / name)) << name;
    if (name.filename() != "material.png") {
      EXPECT_NE(*ReadFile(entry.path()), *ReadFile(dir_ / "c" / name)) << name;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 20);
}

TEST_F(SimulateTest, CancellingLeavesNothingBehind) {
  options_.calibration = true;
  options_.scenes = {"box13.5"};
  std::atomic<bool> cancel{false};
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view, double done) { cancel = cancel || done > 0.2; };
  const auto report = Simulate(options_, dir_ / "out", context);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kCancelled);
  EXPECT_TRUE(Files().empty());
  EXPECT_FALSE(fs::exists(dir_ / "out"));
}

TEST_F(SimulateTest, RefusesAFolderInUseUnlessToldToOverwrite) {
  options_.scenes = {"plane"};
  ASSERT_TRUE(Simulate(options_, dir_ / "out", Context{}).ok());
  options_.scenes = {"sphere20"};
  const auto refused = Simulate(options_, dir_ / "out", Context{});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(fs::exists(dir_ / "out" / "captures" / "plane"));

  ASSERT_TRUE(WriteFile(dir_ / "out" / "notes.txt", "mine").ok());
  options_.overwrite = true;
  ASSERT_TRUE(Simulate(options_, dir_ / "out", Context{}).ok());
  EXPECT_TRUE(fs::exists(dir_ / "out" / "captures" / "sphere20"));
  EXPECT_FALSE(fs::exists(dir_ / "out" / "captures" / "plane")) << "of another run";
  EXPECT_TRUE(fs::exists(dir_ / "out" / "notes.txt")) << "not ours to remove";
}

TEST_F(SimulateTest, RefusesWrongRequestsBeforeWritingAnything) {
  const auto code_of = [&](const SimulateOptions& options) {
    const auto result = Simulate(options, dir_ / "out", Context{});
    return result.ok() ? ErrorCode::kInternal : result.error().code;
  };
  SimulateOptions options = options_;
  options.scenes = {"cube"};
  EXPECT_EQ(code_of(options), ErrorCode::kUsage);
  options.scenes = {"plane", "plane"};
  EXPECT_EQ(code_of(options), ErrorCode::kUsage);
  options.scenes = {"box13.5+off2"};  // there are two lasers
  EXPECT_EQ(code_of(options), ErrorCode::kUsage);
  options = options_;
  options.population = -1;
  EXPECT_EQ(code_of(options), ErrorCode::kUsage);
  options = options_;
  options.device_path = dir_ / "none.toml";
  EXPECT_EQ(code_of(options), ErrorCode::kBadInput);
  EXPECT_FALSE(fs::exists(dir_ / "out"));
}

TEST_F(SimulateTest, ABoardThatDoesNotFitIsSaidInOneSentence) {
  ASSERT_TRUE(WriteFile(options_.device_path, std::string(kSmallDevice) + "[board]\nsquare_mm = 40\n").ok());
  options_.calibration = true;
  const auto report = Simulate(options_, dir_ / "out", Context{});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kBadInput);
  EXPECT_NE(report.error().message.find("chessboard"), std::string::npos);
  EXPECT_TRUE(Files().empty());
}

TEST_F(SimulateTest, TruthOfAMovedObjectIsWhatEachLaserSaw) {
  options_.scenes = {"sphere25", "sphere25+moved3+after"};
  ASSERT_TRUE(Simulate(options_, dir_ / "out", Context{}).ok());
  const fs::path truth = dir_ / "out" / "truth", captures = dir_ / "out" / "captures";
  const auto same = [&](const char* name) {
    return *ReadFile(truth / "sphere25" / name) == *ReadFile(truth / "sphere25+moved3+after" / name);
  };
  EXPECT_TRUE(same("height.png"));
  EXPECT_TRUE(same("stripes0.csv.gz")) << "laser 0 came before the motion";
  EXPECT_FALSE(same("stripes1.csv.gz"));
  const auto scene = ReadJson(truth / "sphere25+moved3+after" / "scene.json");
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ((*scene)["modifiers"][0]["name"], "moved");
  EXPECT_EQ((*scene)["motion"]["from_laser"], 1);
  EXPECT_FALSE(fs::exists(truth / "sphere25" / "scene.json"));
  const auto before = ReadImage(captures / "sphere25+moved3+after" / "bgHand.png");
  const auto after = ReadImage(captures / "sphere25+moved3+after" / "bgHandAfter.png");
  ASSERT_TRUE(before.ok() && after.ok());
  EXPECT_GT(cv::norm(*before, *after, cv::NORM_INF), 40.0) << "its rim is elsewhere";
  EXPECT_FALSE(fs::exists(captures / "sphere25" / "bgHandAfter.png"));
}

TEST_F(SimulateTest, ACaptureOfAnotherDeviceThanTheCalibratedSaysSo) {
  options_.scenes = {"plane+knocked0.5"};
  ASSERT_TRUE(Simulate(options_, dir_ / "out", Context{}).ok());
  const auto calibrated = ReadJson(dir_ / "out" / "truth" / "device.json");
  const auto now = ReadJson(dir_ / "out" / "truth" / "plane+knocked0.5" / "device.json");
  ASSERT_TRUE(calibrated.ok() && now.ok());
  EXPECT_NE((*calibrated)["camera"]["R"], (*now)["camera"]["R"]);
  EXPECT_EQ((*calibrated)["lasers"], (*now)["lasers"]);
}

TEST_F(SimulateTest, APersonComesWithBothHandsAndIsListed) {
  options_.population = 1;
  const auto report = Simulate(options_, dir_ / "out", Context{});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->capture_names, (std::vector<std::string>{"id00_L_k0", "id00_R_k0"}));
  const auto people = ReadJson(dir_ / "out" / "people.json");
  ASSERT_TRUE(people.ok());
  EXPECT_EQ((*people)["people"][0]["captures"][1]["side"], "right");
  const auto hand = ReadImage(dir_ / "out" / "captures" / "id00_R_k0" / "bgHand.png");
  ASSERT_TRUE(hand.ok());
}

}  // namespace
}  // namespace dorsum
