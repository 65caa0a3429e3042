// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct.h"

#include <atomic>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/json.h"
#include "base/temp_folder_test.h"
#include "jobs/evaluate.h"
#include "jobs/scan_fixture_test.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

ReconstructRequest RequestFor(const fs::path& capture, const fs::path& out) {
  ReconstructRequest request;
  request.capture_dir = capture;
  request.calibration_path = ScanFixture::CalibrationJson();
  request.out_dir = out;
  return request;
}

// Reconstructs a capture of the fixture without its report, and compares it.
Evaluation Measure(const std::string& capture, const fs::path& out, EvaluateRequest how) {
  ReconstructRequest request = RequestFor(ScanFixture::CaptureDir(capture), out);
  request.report = false;
  const auto summary = ReconstructFolder(request, {});
  EXPECT_TRUE(summary.ok()) << (summary.ok() ? "" : summary.error().message);
  how.out_dirs = {out};
  const auto evaluation = Evaluate(how, {});
  EXPECT_TRUE(evaluation.ok()) << (evaluation.ok() ? "" : evaluation.error().message);
  return evaluation.ok() ? *evaluation : Evaluation{};
}

std::set<std::string> Names(const fs::path& dir) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(dir)) names.insert(entry.path().filename().string());
  return names;
}

const std::set<std::string> kAllFiles = {"height.json", "height.tiff", "mask.png",    "overview.png",
                                         "points.ply",  "report.html", "report.json", "surface.ply"};

TEST(ReconstructTest, ABoxIsFlatAtItsHeight) {
  const TempFolder dir;
  EvaluateRequest how;
  how.plane_height_mm = 25.5;
  const Evaluation evaluation = Measure(ScanFixture::kBox, dir / "out", how);
  ASSERT_EQ(evaluation.captures.size(), 1U);
  const auto& models = evaluation.captures[0].models;
  ASSERT_EQ(models.size(), 4U) << "three lasers and merged";
  for (const ModelErrors& m : models) {
    EXPECT_LT(m.rmse_mm, 1.2) << m.model;  // at 0.5 mm per pixel
    EXPECT_LT(std::abs(m.bias_mm), 0.8) << m.model;
    EXPECT_GT(m.points, 500U) << m.model;
  }
}

TEST(ReconstructTest, ASphereHasItsRadius) {
  const TempFolder dir;
  EvaluateRequest how;
  how.fit = Shape::kSphere;
  const Evaluation evaluation = Measure(ScanFixture::kSphere, dir / "out", how);
  ASSERT_EQ(evaluation.captures.size(), 1U);
  ASSERT_TRUE(evaluation.captures[0].shape);
  // Plane sheets where the true ones are cones leave a few percent, and so does the fit of a cap.
  EXPECT_NEAR(evaluation.captures[0].shape->radius_mm, 40.0, 3.0);
  // The median: at these few pixels a stripe along the sphere's steep rim may get a neighbour's order.
  EXPECT_LT(evaluation.captures[0].models.back().median_abs_mm, 1.2);
}

TEST(ReconstructTest, AHandLiesWhereTheSimulatorPutIt) {
  const TempFolder dir;
  EvaluateRequest how;
  how.against = ScanFixture::ReferencePly(ScanFixture::kHand);
  const Evaluation evaluation = Measure(ScanFixture::kHand, dir / "out", how);
  ASSERT_EQ(evaluation.captures.size(), 1U);
  const ModelErrors& merged = evaluation.captures[0].models.back();
  EXPECT_GT(merged.points, 3000U);
  EXPECT_LT(merged.outside, merged.points / 50);
  EXPECT_LT(merged.rmse_mm, 1.6);
  const auto mesh = ReadMeshPly(dir / "out" / "surface.ply");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_GT(mesh->faces.size(), 3000U);
}

TEST(ReconstructTest, SameBytesAtOneAndTwoThreads) {
  const TempFolder dir;
  for (const int threads : {1, 2}) {
    Context context;
    context.threads = threads;
    const auto summary = ReconstructFolder(
        RequestFor(ScanFixture::CaptureDir(ScanFixture::kHand), dir / std::to_string(threads)), context);
    ASSERT_TRUE(summary.ok()) << summary.error().message;
  }
  ASSERT_EQ(Names(dir / "1"), kAllFiles);
  ASSERT_EQ(Names(dir / "2"), kAllFiles);
  for (const std::string& file : kAllFiles) {
    const auto one = ReadFile(dir / "1" / file), two = ReadFile(dir / "2" / file);
    ASSERT_TRUE(one.ok() && two.ok()) << file;
    EXPECT_TRUE(*one == *two) << file << " differs";
  }
}

// With a report, stripes are read in colour; without, their green alone.
TEST(ReconstructTest, ReportOrNotTheSurfaceIsTheSame) {
  for (const std::string method : {"default", "classic"}) {
    SCOPED_TRACE(method);
    const TempFolder dir;
    for (const bool report : {true, false}) {
      ReconstructRequest request =
          RequestFor(ScanFixture::CaptureDir(ScanFixture::kBox), dir / (report ? "with" : "without"));
      request.options.method = method;
      request.report = report;
      ASSERT_TRUE(ReconstructFolder(request, {}).ok());
    }
    for (const char* file : {"points.ply", "surface.ply", "height.tiff", "mask.png"}) {
      const auto with = ReadFile(dir / "with" / file), without = ReadFile(dir / "without" / file);
      ASSERT_TRUE(with.ok() && without.ok()) << file;
      EXPECT_TRUE(*with == *without) << file << " differs";
    }
  }
}

TEST(ReconstructTest, ReportJsonCountsWhatTheFilesHold) {
  const TempFolder dir;
  const auto summary =
      ReconstructFolder(RequestFor(ScanFixture::CaptureDir(ScanFixture::kHand), dir / "out"), {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(std::set<std::string>(summary->files.begin(), summary->files.end()), kAllFiles);
  const auto points = ReadPointsPly(dir / "out" / "points.ply");
  const auto mesh = ReadMeshPly(dir / "out" / "surface.ply");
  const auto json = ReadJson(dir / "out" / "report.json");
  ASSERT_TRUE(points.ok() && mesh.ok() && json.ok());
  EXPECT_EQ((*json)["points"], points->size());
  EXPECT_EQ((*json)["triangles"], mesh->faces.size());
  EXPECT_EQ(summary->points, points->size());
  EXPECT_EQ(summary->faces, mesh->faces.size());
  std::size_t of_lasers = 0;
  for (const Json& laser : (*json)["lasers"]) of_lasers += laser["points"].get<std::size_t>();
  EXPECT_EQ(of_lasers, points->size());
  EXPECT_EQ(std::accumulate(summary->points_by_laser.begin(), summary->points_by_laser.end(), std::size_t{0}),
            points->size());
  const auto calibration = ReadFile(ScanFixture::CalibrationJson());
  EXPECT_EQ((*json)["calibration"]["sha256"], Sha256Hex(*calibration));

  const cv::Mat mask = cv::imread((dir / "out" / "mask.png").string(), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(mask.type(), CV_8UC1);
  EXPECT_EQ(mask.size(), cv::Size(560, 420)) << "the captured image's size";
  EXPECT_EQ(cv::countNonZero(mask) - cv::countNonZero(mask == 255), 0) << "0 or 255 only";
  for (const SurfacePoint& p : *points) {
    ASSERT_TRUE(p.position.allFinite() && std::isfinite(p.sigma) && p.sigma > 0.0F);
    ASSERT_NEAR(p.normal.norm(), 1.0, 1e-4);
  }
}

TEST(ReconstructTest, AMissingLaserIsAWarningAndASmallerSurface) {
  const TempFolder dir;
  const auto whole =
      ReconstructFolder(RequestFor(ScanFixture::CaptureDir(ScanFixture::kHand), dir / "whole"), {});
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  EXPECT_TRUE(whole->warnings.empty());
  for (int laser = 0; laser < 3; ++laser) {
    const std::string name = "stripesHand" + std::to_string(laser);
    const fs::path capture = dir / ("without" + std::to_string(laser));
    ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kHand), capture);
    fs::remove(capture / (name + ".png"));
    ReconstructRequest request = RequestFor(capture, dir / ("out" + std::to_string(laser)));
    request.report = laser == 0;
    const auto part = ReconstructFolder(request, {});
    ASSERT_TRUE(part.ok()) << part.error().message;
    EXPECT_EQ(part->points_by_laser[static_cast<std::size_t>(laser)], 0U);
    EXPECT_GT(part->points, whole->points / 2);
    EXPECT_LT(part->points, whole->points);
    ASSERT_EQ(part->warnings.size(), 1U);
    EXPECT_NE(part->warnings[0].find(name), std::string::npos) << part->warnings[0];
  }
}

TEST(ReconstructTest, OneOfThreeLasersCanBeUsedAlone) {
  const TempFolder dir;
  ReconstructRequest request = RequestFor(ScanFixture::CaptureDir(ScanFixture::kBox), dir / "out");
  request.options.lasers = {2};
  request.report = false;
  request.mesh_formats = {"ply", "stl", "obj", "glb"};
  const auto summary = ReconstructFolder(request, {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->points_by_laser, (std::vector<std::size_t>{0, 0, summary->points}));
  EXPECT_EQ(Names(dir / "out").count("report.html"), 0U);
  if (summary->faces > 0) {
    for (const char* file : {"surface.ply", "surface.stl", "surface.obj", "surface.glb"}) {
      EXPECT_EQ(Names(dir / "out").count(file), 1U) << file;
    }
  }
}

TEST(ReconstructTest, ReplacesItsOwnFilesAndKeepsForeignOnes) {
  const TempFolder dir;
  fs::create_directories(dir / "out");
  ASSERT_TRUE(WriteFile(dir / "out" / "notes.txt", "mine").ok());
  ASSERT_TRUE(WriteFile(dir / "out" / "points.ply", "old").ok());
  ReconstructRequest request = RequestFor(ScanFixture::CaptureDir(ScanFixture::kBox), dir / "out");
  request.report = false;
  ASSERT_TRUE(ReconstructFolder(request, {}).ok());
  EXPECT_EQ(*ReadFile(dir / "out" / "notes.txt"), "mine");
  EXPECT_TRUE(ReadPointsPly(dir / "out" / "points.ply").ok());
  EXPECT_EQ(Names(dir.path()), (std::set<std::string>{"out"}));
}

// What an earlier run with a report or another mesh format wrote does not belong to this surface.
TEST(ReconstructTest, LeavesNoFileOfAnEarlierRunBesideItsOwn) {
  const TempFolder dir;
  ReconstructRequest request = RequestFor(ScanFixture::CaptureDir(ScanFixture::kBox), dir / "out");
  request.mesh_formats = {"ply", "stl"};
  request.stages = true;
  ASSERT_TRUE(ReconstructFolder(request, {}).ok());
  EXPECT_EQ(Names(dir / "out").count("stages"), 1U);
  request.stages = false;
  request.mesh_formats = {"ply"};
  request.report = false;
  request.capture_dir = ScanFixture::CaptureDir(ScanFixture::kHand);
  ASSERT_TRUE(ReconstructFolder(request, {}).ok());
  EXPECT_EQ(Names(dir / "out"), (std::set<std::string>{"height.json", "height.tiff", "mask.png", "points.ply",
                                                       "report.json", "surface.ply"}));
}

// Cancelled at each of its reports of progress in turn.
TEST(ReconstructTest, CancelledAnywhereItLeavesNothing) {
  int reports = 0;
  for (int at = 1;; ++at) {
    const TempFolder dir;
    std::atomic<bool> cancel{false};
    Context context;
    context.cancel = &cancel;
    reports = 0;
    context.progress = [&](std::string_view, double) { cancel = cancel || ++reports >= at; };
    const auto summary = ReconstructFolder(
        RequestFor(ScanFixture::CaptureDir(ScanFixture::kBox), dir / "below" / "out"), context);
    if (summary.ok() && !cancel) break;  // `at` is beyond the last report
    ASSERT_FALSE(summary.ok()) << "went on after report " << at;
    EXPECT_EQ(summary.error().code, ErrorCode::kCancelled) << summary.error().message;
    EXPECT_TRUE(fs::is_empty(dir.path())) << "cancelled at report " << at;
  }
  EXPECT_GE(reports, 5);
}

std::string ErrorOf(const std::string& capture, const fs::path& out) {
  const auto summary = ReconstructFolder(RequestFor(ScanFixture::CaptureDir(capture), out), {});
  EXPECT_FALSE(summary.ok()) << capture << " was accepted";
  EXPECT_FALSE(fs::exists(out));
  if (summary.ok()) return "";
  EXPECT_EQ(summary.error().code, ErrorCode::kBadInput);
  return summary.error().message;
}

TEST(ReconstructTest, AHandThatMovedBetweenTheLasersIsRefused) {
  const TempFolder dir;
  const std::string error = ErrorOf(ScanFixture::kMoved, dir / "out");
  EXPECT_NE(error.find(" moved "), std::string::npos) << error;
  EXPECT_NE(error.find("while it was captured"), std::string::npos) << error;
}

TEST(ReconstructTest, AHandAboveTheWorkingVolumeIsRefused) {
  const TempFolder dir;
  EXPECT_NE(ErrorOf(ScanFixture::kHigh, dir / "out").find("reaches out of the working volume"),
            std::string::npos);
}

TEST(ReconstructTest, ADeviceThatWasKnockedIsRefused) {
  const TempFolder dir;
  EXPECT_NE(ErrorOf(ScanFixture::kKnocked, dir / "out").find("calibrate again"), std::string::npos);
}

TEST(ReconstructOptionsTest, EveryDefaultIsAllowedByItsOwnRange) {
  ReconstructOptions options;
  OptionTable table = DescribeReconstructOptions(&options);
  EXPECT_GT(table.specs().size(), 10U);
  for (const OptionSpec& spec : table.specs()) {
    const Status status = table.Set(spec.name, OptionTable::ValueText(spec));
    EXPECT_TRUE(status.ok()) << (status.ok() ? "" : status.error().message);
    EXPECT_FALSE(spec.help.empty()) << spec.name;
  }
}

TEST(ReconstructTest, AnObjectThatMovedWhileItWasCapturedIsSaid) {
  const TempFolder dir;
  const fs::path capture = dir / "capture";
  ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kBox), capture);
  const auto warnings = [&] {
    ReconstructRequest request = RequestFor(capture, dir / "out");
    request.report = false;
    const auto summary = ReconstructFolder(request, {});
    EXPECT_TRUE(summary.ok());
    return summary.ok() ? summary->warnings.size() : 99U;
  };
  const std::size_t usual = warnings();
  const cv::Mat hand = cv::imread((capture / "bgHand.png").string());
  ASSERT_TRUE(cv::imwrite((capture / "bgHandAfter.png").string(), hand));
  EXPECT_EQ(warnings(), usual);
  cv::Mat moved;
  cv::copyMakeBorder(hand.colRange(0, hand.cols - 2), moved, 0, 0, 2, 0, cv::BORDER_REPLICATE);
  ASSERT_TRUE(cv::imwrite((capture / "bgHandAfter.png").string(), moved));
  EXPECT_EQ(warnings(), usual + 1);
}

}  // namespace
}  // namespace dorsum
