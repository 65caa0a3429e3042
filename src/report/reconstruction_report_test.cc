// SPDX-License-Identifier: Apache-2.0
#include "report/reconstruction_report.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "captures/png_image.h"
#include "surface/height_mesh.h"

namespace dorsum {
namespace {

using testing::HasSubstr;
using testing::Not;

ReconstructionReportData SmallData() {
  ReconstructionReportData data;
  data.title = "hand <script>";
  data.photo = cv::Mat(120, 160, CV_8UC3, cv::Scalar(5, 80, 5));
  data.mask = cv::Mat::zeros(120, 160, CV_8UC1);
  data.mask(cv::Rect(40, 30, 80, 60)) = 255;
  LaserStripes stripes;
  stripes.laser = 1;
  for (int row = 30; row < 90; ++row) {
    stripes.points.push_back({.u = 80.0F, .v = static_cast<float>(row)});
    data.points.push_back({.position = {0.0, row / 2.0, 20.0}, .laser = 1, .order = 2, .sigma = 0.25F});
  }
  stripes.segments.push_back({.first = 0, .count = 60, .order = 2});
  data.stripes.lasers = {stripes};
  data.stripes.diagnostics = {{.laser = 1, .segments = 1, .left_out = 0, .corrections = 3}};
  data.height_field.z = cv::Mat1f(40, 60, 20.0F);
  data.mesh = MeshHeightField(data.height_field);
  data.facts = {{"Points", "60", ""}};
  data.settings = {{"sheets", "plane", ""}};
  data.evaluation = {{"Merged", 0.9114, 0.1155, 60}};
  data.calibration = {{"camera", Grade::kGood, "fine", {}}};
  data.warnings = {"laser 3 is missing"};
  data.version = "1.2.3";
  return data;
}

TEST(ReconstructionReport, HoldsAllItsParts) {
  const ReportPages pages = MakeReconstructionReport(SmallData());
  for (const char* text : {"hand &lt;script&gt;", "laser 3 is missing", "0.9114", "data:image/jpeg",
                           "data:image/png", "Dorsum 1.2.3", "&#10003; good", "2 to 2", "0.250"}) {
    EXPECT_THAT(pages.html, HasSubstr(text));
  }
  const cv::Mat overview = DecodePng(pages.overview_png);
  EXPECT_EQ(overview.cols, 1800);
  EXPECT_GT(overview.rows, 900);
}

TEST(ReconstructionReport, AsksNothingOfANetwork) {
  const std::string html = MakeReconstructionReport(SmallData()).html;
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, Not(HasSubstr("https://")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("<link")));
}

TEST(ReconstructionReport, TheSameDataGiveTheSameBytes) {
  const ReportPages a = MakeReconstructionReport(SmallData()), b = MakeReconstructionReport(SmallData());
  EXPECT_EQ(a.html, b.html);
  EXPECT_EQ(a.overview_png, b.overview_png);
}

TEST(ReconstructionReport, NothingAtAllIsStillAReport) {
  ReconstructionReportData data;
  data.stripes.lasers.resize(2);  // lasers that saw nothing
  data.height_field.z = cv::Mat1f(5, 5, std::numeric_limits<float>::quiet_NaN());
  const ReportPages pages = MakeReconstructionReport(data);
  EXPECT_THAT(pages.html, HasSubstr("No surface."));
  EXPECT_THAT(pages.html, Not(HasSubstr("<aside")));
  EXPECT_FALSE(pages.overview_png.empty());
}

}  // namespace
}  // namespace dorsum
