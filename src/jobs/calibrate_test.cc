// SPDX-License-Identifier: Apache-2.0
#include "jobs/calibrate.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/json.h"
#include "base/random.h"
#include "base/temp_folder_test.h"
#include "captures/capture.h"
#include "captures/names.h"
#include "jobs/reconstruct.h"
#include "jobs/scan_fixture_test.h"
#include "simulator/sheet_error.h"
#include "simulator/virtual_device.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The device as the simulator knows it.
VirtualDevice TrueDevice() {
  const auto description = ReadDeviceDescription(ScanFixture::Scan() / "device.toml");
  EXPECT_TRUE(description.ok());
  return BuildVirtualDevice(*description, NamedSeed(ScanFixture::kSeed));
}

Context WithThreads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

// Takes one laser out of a copied series, with its pictures of the boxes.
void RemoveLaser(const fs::path& series, int laser) {
  for (const std::string& name :
       {LaserCalName(laser, Distance::kFurther), LaserCalName(laser, Distance::kCloser),
        LaserChessName(laser, Distance::kFurther), LaserChessName(laser, Distance::kCloser),
        StripesBgName(laser)}) {
    fs::remove(series / (name + ".png"));
  }
  for (const auto& box : fs::directory_iterator(series / kHeightsFolder)) {
    fs::remove(box.path() / (StripesHandName(laser) + ".png"));
  }
}

bool IsEmpty(const TempFolder& dir) { return fs::is_empty(dir.path()); }

TEST(CalibrateTest, FindsTheTrueCameraAndGratings) {
  const Result<Calibration> calibration = ReadCalibration(ScanFixture::CalibrationJson());
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  const VirtualDevice truth = TrueDevice();
  const Camera& camera = calibration->device.camera;
  EXPECT_NEAR(camera.fx, truth.camera.fx, 0.01 * truth.camera.fx);
  EXPECT_NEAR(camera.fy, truth.camera.fy, 0.01 * truth.camera.fy);
  EXPECT_LT((camera.Center() - truth.camera.Center()).norm(), 4.0);
  ASSERT_EQ(calibration->device.lasers.size(), truth.lasers.size());
  for (std::size_t k = 0; k < truth.lasers.size(); ++k) {
    const LaserGeometry& laser = calibration->device.lasers[k];
    const Eigen::Vector3d grating = truth.lasers[k].fan.origin;
    EXPECT_EQ(laser.laser, static_cast<int>(k));
    EXPECT_NEAR(laser.grating.z(), grating.z(), 0.03 * grating.z()) << k;
    EXPECT_GE(laser.planes.size(), 15U) << k;
    EXPECT_GT(laser.correction.c[0] * laser.correction.c[0] + laser.correction.c[1] * laser.correction.c[1],
              0.0)
        << k << ": no correction was fitted";
  }
  for (const PartReport& part : calibration->parts) EXPECT_EQ(part.grade, Grade::kGood) << part.part;
  EXPECT_TRUE(calibration->warnings.empty());
}

TEST(CalibrateTest, ForgetsNoFileThatItWasMadeFrom) {
  const Result<Calibration> calibration = ReadCalibration(ScanFixture::CalibrationJson());
  ASSERT_TRUE(calibration.ok());
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(ScanFixture::CalibrationDir())) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  ASSERT_EQ(calibration->sources.size(), files);
  for (const SourceFile& source : calibration->sources) {
    const auto bytes = ReadFile(ScanFixture::CalibrationDir() / source.name);
    ASSERT_TRUE(bytes.ok()) << source.name;
    EXPECT_EQ(source.sha256, Sha256Hex(*bytes)) << source.name;
  }
}

TEST(CalibrateTest, SameBytesAtOneAndTwoThreads) {
  const TempFolder dir;
  for (const int threads : {1, 2}) {
    const std::string name = std::to_string(threads);
    fs::create_directories(dir / name);
    const auto run = CalibrateFolder(ScanFixture::CalibrationDir(), dir / name / "calibration.json", {},
                                     WithThreads(threads));
    ASSERT_TRUE(run.ok()) << run.error().message;
  }
  for (const char* file : {"calibration.json", "calibration.html"}) {
    const auto one = ReadFile(dir / "1" / file), two = ReadFile(dir / "2" / file);
    ASSERT_TRUE(one.ok() && two.ok()) << file;
    EXPECT_TRUE(*one == *two) << file << " differs";
  }
}

// Lasers 0 and 1, and lasers 0 and 2: without laser 1 the lowest fixes the world.
TEST(CalibrateTest, ADeviceWithoutOneOfTheLasersWorks) {
  for (const int absent : {2, 1}) {
    SCOPED_TRACE("without laser " + std::to_string(absent));
    const TempFolder dir;
    ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), dir / "series");
    RemoveLaser(dir / "series", absent);
    const auto run = CalibrateFolder(dir / "series", dir / "c.json", {}, {});
    ASSERT_TRUE(run.ok()) << run.error().message;
    ASSERT_EQ(run->calibration.device.lasers.size(), 2U);
    EXPECT_EQ(run->calibration.device.FindLaser(absent), nullptr);

    ReconstructRequest request;
    request.capture_dir = ScanFixture::CaptureDir(ScanFixture::kBox);
    request.calibration_path = dir / "c.json";
    request.out_dir = dir / "out";
    const auto summary = ReconstructFolder(request, {});
    ASSERT_TRUE(summary.ok()) << summary.error().message;
    EXPECT_GT(summary->points, 1000U);
    EXPECT_TRUE(fs::exists(dir / "out" / "report.html"));
  }
}

TEST(CalibrateTest, ConesGiveTrueHeightsOverTheWholeVolume) {
  const Result<Calibration> calibration = ReadCalibration(ScanFixture::CalibrationJson());
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  EXPECT_EQ(calibration->method, "bundle");
  const std::vector<SheetError> errors = MeasureSheetError(calibration->device, TrueDevice());
  ASSERT_EQ(errors.size(), 3U);
  for (const SheetError& e : errors) {
    EXPECT_GT(e.points, 500U);
    EXPECT_EQ(e.lost, 0U);
    EXPECT_LT(e.rms_mm, 0.04) << "laser " << e.laser;  // of pixels three times as coarse as usual
    const LaserGeometry* laser = calibration->device.FindLaser(e.laser);
    ASSERT_NE(laser, nullptr);
    EXPECT_GT(laser->residual_mm, 0.2 * e.rms_mm) << "too sure of itself";
    EXPECT_LT(laser->residual_mm, 0.2);
  }
}

// The document's planes stand in the same file, count orders alike and belong to the same camera.
TEST(CalibrateTest, PlanesAndConesOfOneFileAgreeOnTheBackplane) {
  const Result<Calibration> calibration = ReadCalibration(ScanFixture::CalibrationJson());
  ASSERT_TRUE(calibration.ok());
  for (const LaserGeometry& laser : calibration->device.lasers) {
    ASSERT_FALSE(laser.planes.empty());
    ASSERT_TRUE(laser.fan.has_value());
    EXPECT_LE(laser.min_order, -5);
    EXPECT_GE(laser.max_order, 5);
    const Eigen::Vector2d pixel = Project(calibration->device.camera, {20.0, 0.0, 0.0});
    const auto by_plane = OrderAtHeight(calibration->device.camera, laser, SheetModel::kPlane, pixel, 0.0);
    const auto by_cone = OrderAtHeight(calibration->device.camera, laser, SheetModel::kCone, pixel, 0.0);
    ASSERT_TRUE(by_plane && by_cone);
    EXPECT_NEAR(by_plane.value_or(1e9), by_cone.value_or(-1e9), 0.1) << laser.laser;
  }
}

TEST(CalibrateTest, ConesNeedNoBoxes) {
  const TempFolder dir;
  ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), dir / "series");
  fs::remove_all(dir / "series" / kHeightsFolder);
  const auto run = CalibrateFolder(dir / "series", dir / "c.json", {}, {});
  ASSERT_TRUE(run.ok()) << run.error().message;
  for (const PartReport& part : run->calibration.parts) EXPECT_EQ(part.grade, Grade::kGood) << part.verdict;
  for (const SheetError& e : MeasureSheetError(run->calibration.device, TrueDevice()))
    EXPECT_LT(e.rms_mm, 0.06) << e.laser;
}

// A box without one laser is a smaller calibration; the hand's picture of it is no part of a bundle, but a
// bad one tells of a bad copy.
TEST(CalibrateTest, PicturesOfABoxAreLookedAtOneByOne) {
  const TempFolder dir;
  ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), dir / "series");
  const fs::path box = fs::directory_iterator(dir / "series" / kHeightsFolder)->path();
  fs::remove(box / (StripesHandName(1) + ".png"));
  const auto run = CalibrateFolder(dir / "series", dir / "c.json", {}, {});
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_THAT(run->calibration.warnings, ::testing::Contains(MissingStripes(box, 1)));
  ASSERT_EQ(run->correction.size(), 3U);
  for (const LaserCorrection& c : run->correction) {
    EXPECT_GT(c.fit.samples, 50U) << c.laser;
    EXPECT_LT(c.fit.rms_after_mm, c.fit.rms_before_mm) << c.laser;
  }

  const fs::path hand = box / (std::string(kBgHandName) + ".png");
  fs::resize_file(hand, fs::file_size(hand) / 2);
  const auto cut = CalibrateFolder(dir / "series", dir / "cut.json", {}, {});
  ASSERT_FALSE(cut.ok());
  EXPECT_EQ(cut.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(cut.error().message, ::testing::HasSubstr(hand.string()));
  EXPECT_FALSE(fs::exists(dir / "cut.json"));
}

TEST(CalibrateTest, AWrongHeightInSetupIsSaidAndDoesNoHarm) {
  const TempFolder dir;
  ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), dir / "series");
  auto setup = ReadJson(dir / "series" / kSetupName);
  ASSERT_TRUE(setup.ok());
  (*setup)["calibration_object_height_mm"] = 51.4;
  ASSERT_TRUE(WriteJson(dir / "series" / kSetupName, *setup).ok());
  const auto run = CalibrateFolder(dir / "series", dir / "c.json", {}, {});
  ASSERT_TRUE(run.ok()) << run.error().message;
  const auto& parts = run->calibration.parts;
  const auto heights =
      std::find_if(parts.begin(), parts.end(), [](const auto& p) { return p.part == "known heights"; });
  ASSERT_NE(heights, parts.end());
  EXPECT_THAT(heights->verdict, ::testing::HasSubstr("given as 51.4 mm, fits 50.0 mm"));
  for (const SheetError& e : MeasureSheetError(run->calibration.device, TrueDevice()))
    EXPECT_LT(e.rms_mm, 0.08) << e.laser;
}

TEST(CalibrateTest, WithoutBoxesHeightsStayUncorrectedAndThatIsSaid) {
  const TempFolder dir;
  ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), dir / "series");
  fs::remove_all(dir / "series" / kHeightsFolder);
  CalibrateOptions options;
  options.method = "classic";
  const auto run = CalibrateFolder(dir / "series", dir / "c.json", options, {});
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_EQ(run->calibration.warnings.size(), 3U) << "one for each box";
  EXPECT_EQ(run->calibration.parts.back().grade, Grade::kDoubtful);
}

// Cancelled at each of its reports of progress in turn; fewer pictures make the same reports.
TEST(CalibrateTest, CancelledAnywhereItLeavesNothing) {
  const TempFolder dir;
  ScanFixture::CopyFolder(ScanFixture::CalibrationDir(), dir / "series");
  RemoveLaser(dir / "series", 2);
  for (const double height : {10.0, 40.0})
    fs::remove_all(dir / "series" / kHeightsFolder / HeightFolderName(height));
  const fs::path out = dir / "out";
  fs::create_directories(out);
  int reports = 0;
  for (int at = 1;; ++at) {
    std::atomic<bool> cancel{false};
    Context context;
    context.cancel = &cancel;
    reports = 0;
    context.progress = [&](std::string_view, double) { cancel = cancel || ++reports >= at; };
    const auto run = CalibrateFolder(dir / "series", out / "c.json", {}, context);
    if (run.ok() && !cancel) break;  // `at` is beyond the last report
    ASSERT_FALSE(run.ok()) << "went on after report " << at;
    ASSERT_EQ(run.error().code, ErrorCode::kCancelled) << run.error().message;
    EXPECT_TRUE(fs::is_empty(out)) << "cancelled at report " << at;
  }
  EXPECT_GE(reports, 5);
}

TEST(CalibrateTest, ReportDoesNotWaitForAPlaceToWrite) {
  const TempFolder dir;
  int reports = 0;
  Context context;
  context.progress = [&](std::string_view, double) { ++reports; };
  for (const fs::path& out : {dir / "none" / "c.json", dir.path(), dir / "c.html"}) {
    const auto run = CalibrateFolder(ScanFixture::CalibrationDir(), out, {}, context);
    ASSERT_FALSE(run.ok()) << out;
    EXPECT_NE(run.error().message.find(out.string()), std::string::npos) << run.error().message;
  }
  EXPECT_EQ(reports, 0) << "a minute of work was thrown away";
  EXPECT_TRUE(IsEmpty(dir));
}

}  // namespace
}  // namespace dorsum
