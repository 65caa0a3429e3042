// SPDX-License-Identifier: Apache-2.0
#include "captures/calibration_series.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "captures/names.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A folder with two lasers (0 and 2) and two boxes, each image 32x24.
class CalibrationSeriesTest : public ::testing::Test {
 protected:
  CalibrationSeriesTest() {
    std::vector<std::string> names = {"laserCalFurtherBg", "laserCalCloserBg", "laserFirstEstimates",
                                      "bgNoHand"};
    for (int view = 0; view < kChessViews; ++view) names.push_back(ChessName(view));
    for (const std::string k : {"0", "2"}) {
      for (const std::string& name :
           {"laser" + k + "CalFurther", "laser" + k + "CalCloser", "laser" + k + "CalFurtherChess",
            "laser" + k + "CalCloserChess", "stripesBg" + k}) {
        names.push_back(name);
      }
    }
    const cv::Mat image(24, 32, CV_8UC3, cv::Scalar(10, 20, 30));
    for (const std::string& name : names) cv::imwrite((folder_ / (name + ".png")).string(), image);
    for (const char* box : {"h13.5", "h27.0"}) {
      std::filesystem::create_directories(folder_ / "heights" / box);
      cv::imwrite((folder_ / "heights" / box / "bgHand.png").string(), image);
    }
    EXPECT_TRUE(
        WriteFile(folder_ / "setup.json", R"({"chessboard": {"inner_corners": [9, 6], "square_mm": 20},
      "calibration_object_height_mm": 40, "box_heights_mm": [13.5, 27], "grating_lines_per_mm": 100,
      "wavelength_nm": 532, "camera_resolution": [32, 24]})")
            .ok());
  }
  void Remove(const std::string& name) { ASSERT_TRUE(std::filesystem::remove(folder_ / (name + ".png"))); }
  std::string Message() {
    const auto series = LoadCalibrationSeries(folder_.path());
    if (series.ok()) return "(no error)";
    EXPECT_EQ(series.error().code, ErrorCode::kBadInput);
    return series.error().message;
  }
  TempFolder folder_;
};

TEST_F(CalibrationSeriesTest, ACompleteFolderHasNoWarning) {
  const auto series = LoadCalibrationSeries(folder_.path());
  ASSERT_TRUE(series.ok()) << series.error().message;
  EXPECT_THAT(series->lasers, ElementsAre(0, 2));
  EXPECT_EQ(series->chess_views.size(), 12U);
  EXPECT_THAT(series->box_heights_mm, ElementsAre(13.5, 27.0));
  EXPECT_THAT(series->warnings, IsEmpty());
  EXPECT_EQ(series->Read("bgNoHand").value().size(), cv::Size(32, 24));
  const auto files = series->Files();
  EXPECT_EQ(files.size(), 4U + 12U + 10U + 2U + 1U);
  EXPECT_THAT(files, Contains("setup.json"));
  EXPECT_TRUE(std::is_sorted(files.begin(), files.end()));
}

TEST_F(CalibrationSeriesTest, WhatIsLookedAtTwiceIsDecodedOnce) {
  const CalibrationSeries series = LoadCalibrationSeries(folder_.path()).value().KeepingPictures();
  const cv::Mat first = series.Read("stripesBg2").value();
  EXPECT_EQ(series.Read("stripesBg2").value().data, first.data);
  const cv::Mat green = series.Read("stripesBg2", Channels::kGreen).value();
  ASSERT_EQ(green.type(), CV_8UC1);
  EXPECT_EQ(green.at<std::uint8_t>(5, 5), first.at<cv::Vec3b>(5, 5)[1]);
  EXPECT_NE(series.Read("chess00").value().data, series.Read("chess00").value().data);
}

TEST_F(CalibrationSeriesTest, EachIndispensableFileIsNamed) {
  for (const char* name : {"laserFirstEstimates", "bgNoHand", "laserCalFurtherBg", "laserCalCloserBg",
                           "chess00", "heights/h27.0/bgHand"}) {
    const std::string bytes = ReadFile(folder_ / (std::string(name) + ".png")).value();
    Remove(name);
    EXPECT_THAT(Message(),
                AllOf(HasSubstr(std::filesystem::path(name).filename().string()), HasSubstr("missing")));
    ASSERT_TRUE(WriteFile(folder_ / (std::string(name) + ".png"), bytes).ok());
  }
  EXPECT_EQ(Message(), "(no error)");
}

TEST_F(CalibrationSeriesTest, ALaserThatIsBegunMustBeWhole) {
  for (const char* name : {"laser2CalFurther", "laser2CalCloser", "laser2CalFurtherChess",
                           "laser2CalCloserChess", "stripesBg2"}) {
    const std::string bytes = ReadFile(folder_ / (std::string(name) + ".png")).value();
    Remove(name);
    EXPECT_THAT(Message(), HasSubstr(name));
    ASSERT_TRUE(WriteFile(folder_ / (std::string(name) + ".png"), bytes).ok());
  }
  ASSERT_TRUE(WriteFile(folder_ / "stripesBg5.png", "x").ok());
  EXPECT_THAT(Message(), HasSubstr("laser5"));
}

TEST_F(CalibrationSeriesTest, NoLasersIsAnError) {
  for (const std::string k : {"0", "2"}) {
    for (const std::string& name :
         {"laser" + k + "CalFurther", "laser" + k + "CalCloser", "laser" + k + "CalFurtherChess",
          "laser" + k + "CalCloserChess", "stripesBg" + k}) {
      Remove(name);
    }
  }
  EXPECT_THAT(Message(), HasSubstr("laser0CalFurther"));
}

TEST_F(CalibrationSeriesTest, WhatCanBeDoneWithoutIsAWarning) {
  Remove("chess07");
  std::filesystem::remove_all(folder_ / "heights/h27.0");
  const auto series = LoadCalibrationSeries(folder_.path());
  ASSERT_TRUE(series.ok());
  EXPECT_THAT(series->warnings, ElementsAre(HasSubstr("chess07"), HasSubstr("h27.0")));
  EXPECT_EQ(series->chess_views.size(), 11U);
  EXPECT_THAT(series->box_heights_mm, ElementsAre(13.5));
}

TEST_F(CalibrationSeriesTest, AMissingFolderOrSetupIsNamed) {
  EXPECT_THAT(LoadCalibrationSeries(folder_ / "none").error().message, HasSubstr("none"));
  std::filesystem::remove(folder_ / "setup.json");
  EXPECT_THAT(Message(), HasSubstr("setup.json"));
}

TEST_F(CalibrationSeriesTest, AnImageOfAnotherResolutionThanTheSetupSaysIsRefused) {
  cv::imwrite((folder_ / "bgNoHand.png").string(), cv::Mat(24, 33, CV_8UC3, cv::Scalar::all(9)));
  const auto series = LoadCalibrationSeries(folder_.path());
  ASSERT_TRUE(series.ok());
  EXPECT_THAT(series->Read("bgNoHand").error().message, AllOf(HasSubstr("33x24"), HasSubstr("32x24")));
  EXPECT_FALSE(series->Read("chess99").ok());
}

}  // namespace
}  // namespace dorsum
