// SPDX-License-Identifier: Apache-2.0
#include "jobs/design.h"

#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "captures/device_description_toml.h"
#include "jobs/design_report.h"
#include "simulator/simulate.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// A picture so small that simulating it takes no time.
DesignRequest Small(const fs::path& out = {}) {
  DesignRequest request;
  request.changes.resolution_px = {160, 120};
  request.changes.focal_length_px = 208.0;
  request.out_dir = out;
  return request;
}

bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Design, WhatIsWrittenIsWhatSimulateTakes) {
  const TempFolder dir;
  DesignRequest request = Small(dir / "mine");
  request.changes.lines_per_mm = 80.0;
  request.changes.lasers = 2;
  request.changes.pitch_mm = 17.0;
  request.changes.baseline_mm = 140.0;
  request.changes.slit_um = 0.7;
  const auto summary = Design(request, {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  for (const char* name : {"device.toml", "design.json", "design.png", "design.html"})
    EXPECT_GT(fs::file_size(dir.path() / "mine" / name), 500U) << name;
  const fs::path toml = dir.path() / "mine" / "device.toml";
  const auto again = ReadDeviceDescription(toml);
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(DeviceDescriptionToToml(*again), DeviceDescriptionToToml(summary->report.device.description));
  EXPECT_EQ(again->lasers.size(), 2U);
  EXPECT_EQ(again->grating.lines_per_mm, 80.0);
  EXPECT_NEAR(again->lasers[1].position_mm.x() - again->lasers[0].position_mm.x(), 17.0, 1e-12);
  SimulateOptions simulate;
  simulate.device_path = toml;
  simulate.calibration = false;
  simulate.scenes = {"plane"};
  const auto scan = Simulate(simulate, dir.path() / "scan", {});
  EXPECT_TRUE(scan.ok()) << scan.error().message;
  EXPECT_TRUE(fs::exists(dir.path() / "scan" / "captures" / "plane"));
  // The same design again, from its own file.
  DesignRequest second;
  second.device_path = toml;
  const auto twice = Design(second, {});
  ASSERT_TRUE(twice.ok());
  EXPECT_EQ(twice->report.merit, summary->report.merit);
}

// The simulator cannot calibrate a device whose board does not fit into the picture.
TEST(Design, ABoardTooLargeForTheViewShrinks) {
  DesignRequest request;
  request.changes.camera_height_mm = 285.0;
  request.changes.baseline_mm = 100.0;
  const auto summary = Design(request, {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_LT(summary->report.device.description.board.square_mm, 15.0);
  EXPECT_GT(summary->report.device.description.board.square_mm, 8.0);
  EXPECT_TRUE(Has(summary->report.warnings.back(), "chessboard"));
  EXPECT_EQ(Design({}, {})->report.device.description.board.square_mm, 15.0);
}

TEST(Design, PageAndTablesHoldTheFigures) {
  const TempFolder dir;
  const auto summary = Design(Small(dir / "mine"), {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  const std::string html = *ReadFile(dir.path() / "mine" / "design.html");
  EXPECT_TRUE(Has(html, "Expected error"));
  EXPECT_FALSE(Has(html, "<script"));
  const cv::Mat picture = cv::imread((dir.path() / "mine" / "design.png").string());
  EXPECT_GT(picture.cols, 1000);
  const std::string text = SummaryToText(*summary);
  for (const char* part :
       {"orders of laser 0", "depth per pixel", "unambiguous", "points per cm2", "written:"})
    EXPECT_TRUE(Has(text, part)) << part;
  const Json json = SummaryToJson(*summary);
  EXPECT_EQ(json["schema"], "dorsum/design");
  EXPECT_EQ(json["orders"].size(), 21U);
  EXPECT_EQ(json["lasers"].size(), 4U);
  EXPECT_FALSE(Has(json.dump(), "null,null"));
}

TEST(Design, AThousandLinesAreExplainedAndStillDesigned) {
  DesignRequest request;
  request.changes.lines_per_mm = 1000.0;
  const auto summary = Design(request, {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  ASSERT_EQ(summary->report.explanations.size(), 1U);
  const std::string why = summary->report.explanations[0];
  EXPECT_TRUE(Has(why, "0.376")) << why;
  EXPECT_TRUE(Has(why, "160 mm beside")) << why;
  EXPECT_TRUE(Has(why, "1 stripe of a laser")) << why;
  EXPECT_TRUE(Has(why, "need 101 lines/mm")) << why;
  EXPECT_EQ(summary->report.device.description.grating.orders, 2);
  EXPECT_TRUE(Design({}, {})->report.explanations.empty());
  request.changes.lines_per_mm = 4000.0;
  const auto none = Design(request, {});
  ASSERT_FALSE(none.ok());
  EXPECT_TRUE(Has(none.error().message, "no order but the central one")) << none.error().message;
}

TEST(Design, BadRequestsNameWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [](const DesignRequest& request) {
    const auto summary = Design(request, {});
    if (summary.ok()) return std::string("(no error)");
    EXPECT_FALSE(Has(summary.error().message, "\n"));
    return summary.error().message;
  };
  DesignRequest r;
  r.device_path = "no/such/device.toml";
  EXPECT_TRUE(Has(message(r), "no/such/device.toml"));
  r = {};
  r.hand_mm = {190.0, nan};
  EXPECT_TRUE(Has(message(r), "--hand-mm"));
  r = {};
  r.surface.albedo = nan;
  EXPECT_TRUE(Has(message(r), "--albedo"));
  r = {};
  r.surface.pooled_rows = 0;
  EXPECT_TRUE(Has(message(r), "--pooled-rows"));
  for (const double bad : {nan, 0.0, -3.0, 1e9}) {
    r = {};
    r.changes.lines_per_mm = bad;
    EXPECT_TRUE(Has(message(r), "lines")) << bad << message(r);
    r = {};
    r.changes.focal_length_px = bad;
    EXPECT_TRUE(Has(message(r), "focal_length_px")) << bad << message(r);
    r = {};
    r.changes.slit_um = bad;
    EXPECT_TRUE(Has(message(r), "slit")) << bad << message(r);
  }
  r = {};
  r.changes.heights_mm = {80.0, 0.0};
  EXPECT_TRUE(Has(message(r), "working_heights_mm"));
  for (const double bad : {nan, 1e9}) {
    r = {};
    r.changes.baseline_mm = bad;
    EXPECT_TRUE(Has(message(r), "position_mm")) << bad << message(r);
  }
  r = {};
  r.changes.lasers = 9;
  EXPECT_TRUE(Has(message(r), "lasers"));
}

TEST(Design, NowhereToWriteLeavesNothing) {
  const TempFolder dir;
  ASSERT_TRUE(WriteFile(dir / "file", "mine").ok());
  const auto summary = Design(Small(dir.path() / "file" / "mine"), {});
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(summary.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(*ReadFile(dir / "file"), "mine");
}

TEST(DesignSearch, TheBestMeetsTheConstraintsAndTheRestSaysWhy) {
  DesignRequest request;
  request.search.emplace();
  request.search->gratings = {50, 100, 150, 1000};
  request.search->baselines_mm = {70.0, 130.0};
  const auto summary = Design(request, {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  const SearchResult& found = *summary->search;
  ASSERT_GE(found.hits.size(), 2U);
  for (std::size_t i = 1; i < found.hits.size(); ++i) EXPECT_GE(found.hits[i - 1].merit, found.hits[i].merit);
  EXPECT_EQ(found.hits.size() + found.refused.size(), 4U);
  EXPECT_TRUE(Has(found.refused.back(), "1000 lines/mm gives at most 3 stripes")) << found.refused.back();
  // The best, judged anew and finer.
  const DesignReport& best = summary->report;
  EXPECT_EQ(best.device.description.grating.lines_per_mm, found.hits[0].description.grating.lines_per_mm);
  EXPECT_NEAR(best.merit / found.hits[0].merit, 1.0, 0.1);
  for (const LaserFigures& laser : best.lasers) {
    EXPECT_GE(laser.unambiguous_mm, 0.95 * 30.0);
    EXPECT_GE(laser.volume.used, 0.88);
    EXPECT_GE(laser.volume.narrowest, 0.95 * 8.0);
  }
  EXPECT_TRUE(SeenRectangle(best.device.camera, 80.0).contains(best.device.hand));
  EXPECT_TRUE(ParseDeviceDescription(DeviceDescriptionToToml(best.device.description), "best").ok());
}

TEST(DesignSearch, ImpossibleWishesAreAnsweredWithNo) {
  DesignRequest request;
  request.search.emplace();
  request.search->gratings = {70};
  request.search->least_unambiguous_mm = 200.0;
  const auto summary = Design(request, {});
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(summary.error().code, ErrorCode::kAnswerIsNo);
  EXPECT_TRUE(Has(summary.error().message, "70 lines/mm")) << summary.error().message;
  request.search->gratings = {0.0};
  EXPECT_EQ(Design(request, {}).error().code, ErrorCode::kUsage);
  request.search->gratings = {};
  EXPECT_EQ(Design(request, {}).error().code, ErrorCode::kUsage);
  request.search->gratings = {100};
  request.search->baselines_mm = {200.0, 100.0};
  EXPECT_EQ(Design(request, {}).error().code, ErrorCode::kUsage);
}

TEST(DesignSearch, LasersInterleaveOverTheVolume) {
  DeviceDescription d = DefaultDevice();
  const double pitch = BestPitch(d, 10.0);
  EXPECT_GE(pitch, 10.0);
  PlaceLasers(4, pitch, 0.0, &d.lasers);
  const auto gaps = [](const DeviceDescription& device) {
    double sum = 0.0;
    for (const CombFigures& c : FindCombs(*LayOutDevice(device, {190, 110}), 5)) sum += c.largest_gap_mm;
    return sum;
  };
  EXPECT_LT(gaps(d), gaps(DefaultDevice()));
}

}  // namespace
}  // namespace dorsum
