// SPDX-License-Identifier: Apache-2.0
#include "report/calibration_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

using testing::HasSubstr;
using testing::Not;

CalibrationReportData SmallData() {
  CalibrationReportData data;
  data.method = "classic";
  data.classic.camera.views = {"chess00"};
  data.classic.camera.view_rms_px = {0.123};
  data.classic.camera.corners = {{{20.0F, 20.0F}, {40.0F, 20.0F}}};
  LaserCalibration laser;
  laser.laser = 2;
  laser.grating.height_mm = 401.25;
  laser.further.picture = cv::Mat(40, 200, CV_8UC3, cv::Scalar(10, 90, 10));
  for (int row = 0; row < 100; ++row)
    laser.background.stripes.points.push_back({.u = 50.0F, .v = 1.0F * row});
  laser.background.stripes.segments.push_back({.first = 0, .count = 100, .order = -1});
  laser.background.lines = {{.order = -1}, {.order = 4}};
  data.classic.lasers = {laser};
  LaserCorrection correction;
  correction.laser = 2;
  for (double x = -50.0; x < 50.0; x += 1.0) correction.samples.push_back({x, 20.5, 20.0});
  correction.fit.rms_before_mm = 0.5;
  data.correction = {correction};
  data.parts = {{"camera", Grade::kGood, "explains its boards", {{"rms", 0.123, "px"}}},
                {"laser 2", Grade::kBad, "sees nothing", {}}};
  data.board_photo = cv::Mat(100, 140, CV_8UC3, cv::Scalar(5, 80, 5));
  data.warnings = {"<b>careful</b>"};
  data.sources = 7;
  return data;
}

TEST(CalibrationReport, HoldsAllItsParts) {
  const std::string html = MakeCalibrationReport(SmallData());
  for (const char* text : {"401.25", "-1 to 4", "chess00", "0.123", "&#10003; good", "&#10007; bad",
                           "Laser 2: what is left.", "&lt;b&gt;careful", "0.500"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, Not(HasSubstr("https://")));
  EXPECT_EQ(html, MakeCalibrationReport(SmallData()));
}

TEST(CalibrationReport, NothingAtAllIsStillAReport) {
  CalibrationReportData data;
  data.classic.lasers.resize(1);
  data.correction.resize(1);
  data.classic.camera.views = {"chess00"};  // without its error
  EXPECT_THAT(MakeCalibrationReport(data), HasSubstr("</html>"));
  EXPECT_THAT(MakeCalibrationReport({}), HasSubstr("</html>"));
}

}  // namespace
}  // namespace dorsum
