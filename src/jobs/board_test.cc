// SPDX-License-Identifier: Apache-2.0
#include "jobs/board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/temp_folder_test.h"
#include "calibration/chessboard.h"
#include "calibration/first_estimates.h"
#include "captures/designed_geometry.h"
#include "captures/green_channel.h"
#include "jobs/scan_fixture_test.h"
#include "report/printed_pdf_test.h"
#include "report/printed_targets.h"
#include "simulator/renderer.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The parts of the fixture's device with no error of mounting.
std::string PerfectDevice() {
  std::string text = ScanFixture::kDevice;
  const std::string mounting = "[mounting]\nprincipal_point_px = 3.0\n";
  text.replace(text.find(mounting), mounting.size(),
               "[mounting]\ncamera_position_mm = 0\ncamera_angle_deg = 0\nlaser_position_mm = 0\n"
               "laser_angle_deg = 0\ngrating_turn_deg = 0\nfocal_length_share = 0\nprincipal_point_px = 0\n");
  return text;
}

// What a printed page looks like when it lies on the backplane, its target's middle at (x, y): the backplane
// painted with the picture of the page, smoothed to what one pixel sees.
Pattern PageOnBackplane(const cv::Mat& page, double px_per_mm, const cv::Point2d& middle_px,
                        const Eigen::Vector2d& at) {
  cv::Mat blurred;
  cv::GaussianBlur(page, blurred, {0, 0}, 0.25 * px_per_mm);
  return [blurred, px_per_mm, middle_px, at](const Eigen::Vector3d& world, double) {
    const int u = cvRound(middle_px.x + (world.x() - at.x()) * px_per_mm);
    const int v = cvRound(middle_px.y - (world.y() - at.y()) * px_per_mm);
    const bool on_page = u >= 0 && v >= 0 && u < blurred.cols && v < blurred.rows;
    const double white = on_page ? blurred.at<std::uint8_t>(v, u) / 255.0 : 1.0;
    return Paint{Material::kBoardWhite, 0.045 + white * (0.82 - 0.045)};
  };
}

class BoardTest : public ::testing::Test {
 protected:
  BoardTest() {
    EXPECT_TRUE(WriteFile(dir_ / "device.toml", PerfectDevice()).ok());
    options_.device_path = dir_ / "device.toml";
    device_ = BuildVirtualDevice(ReadDeviceDescription(options_.device_path).value(), 3);
  }
  // A photograph of sheet `name` as the job prints it, lying on the backplane.
  cv::Mat Photograph(const std::string& name, const PrintedSheet& sheet, const Eigen::Vector2d& at) {
    const double px_per_mm = 200.0 / 25.4;
    const auto report = PrintBoards(options_, dir_ / "targets", {});
    EXPECT_TRUE(report.ok()) << report.error().message;
    const cv::Mat page = DrawnPages(ReadFile(dir_ / "targets" / (name + ".pdf")).value(), 200).at(0);
    const SheetLayout layout = LayOutSheet(sheet, options_.paper).value();
    const cv::Point2d middle = PixelOf(TileCorner(layout) + 0.5 * layout.tile_mm, layout, px_per_mm);
    Scene scene;
    scene.parts.push_back(Backplane());
    scene.parts[0].pattern = PageOnBackplane(page, px_per_mm, middle, at);
    return Render(std::move(scene));
  }
  cv::Mat Render(Scene scene) {
    const Result<Stage> stage = SetStage(device_, std::move(scene), {});
    return RenderLeds(device_, *stage, 5, {}).value();
  }

  const TempFolder dir_;
  BoardOptions options_;
  VirtualDevice device_;
};

TEST_F(BoardTest, TheDetectorFindsThePrintedChessboardInAPhotograph) {
  const BoardDesign& board = device_.description.board;
  const Eigen::Vector2d at(2.0, -1.0);
  const cv::Mat photo = Photograph("chessboard", ChessboardTarget("small", board), at);
  const cv::Size inner(board.columns, board.rows);
  const auto corners = FindChessboard(GreenChannel(photo), inner);
  ASSERT_TRUE(corners.has_value());
  const std::vector<cv::Point3f> points = ChessboardPoints(inner, board.square_mm);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d expected =
        Project(device_.camera, {at.x() + points[i].x, at.y() - points[i].y, 0.0});
    EXPECT_LT(cv::norm(cv::Point2d((*corners)[i]) - cv::Point2d(expected.x(), expected.y())), 0.3) << i;
  }
}

TEST_F(BoardTest, CalibrationFindsThePrintedLinesAndNothingElse) {
  std::vector<CentralLine> lines;
  std::vector<double> truth;
  for (const VirtualLaser& laser : device_.lasers) {
    const StripePointOnPlane on_world = CentralStripeAt(laser.fan, 0.0, 0.0);
    truth.push_back(on_world.point.x());
    lines.push_back({static_cast<int>(lines.size()), on_world.point.x(), Eigen::Vector2d::UnitY()});
  }
  const double middle = 0.5 * (truth.front() + truth.back());
  const cv::Mat photo =
      Photograph("first-estimates", FirstEstimatesTarget("small", lines, 130.0), {middle, 0.0});
  Scene empty;
  empty.parts.push_back(Backplane());
  CalibrationSeries series;
  series.dir = dir_.path();
  series.setup.width = photo.cols;
  series.setup.height = photo.rows;
  ASSERT_TRUE(cv::imwrite(dir_ / "laserFirstEstimates.png", photo));
  ASSERT_TRUE(cv::imwrite(dir_ / "bgNoHand.png", Render(std::move(empty))));
  const auto drawn = FindDrawnLines(series, {}, {});
  ASSERT_TRUE(drawn.ok()) << drawn.error().message;
  const std::vector<double> found = PlacesOfLines(*drawn, device_.camera);
  // A pixel is 0.55 mm here.
  ASSERT_EQ(found.size(), truth.size()) << "words or rulers were taken for lines, or lines were missed";
  for (std::size_t k = 0; k < truth.size(); ++k) EXPECT_NEAR(found[k], truth[k], 0.8);
}

TEST_F(BoardTest, OneFileOrAFolderAndTheSameBytesEachTime) {
  const auto file = PrintBoards(options_, dir_ / "all.pdf", {});
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ(file->files, std::vector<std::string>{(dir_ / "all.pdf").string()});
  int pages = 0;
  for (const BoardReport::Sheet& sheet : file->sheets) pages += sheet.pages;
  const std::string bytes = ReadFile(dir_ / "all.pdf").value();
  EXPECT_EQ(DrawnPages(bytes, 20).size(), static_cast<std::size_t>(pages));
  ASSERT_TRUE(PrintBoards(options_, dir_ / "again.PDF", {}).ok());
  EXPECT_EQ(ReadFile(dir_ / "again.PDF").value(), bytes);

  options_.sheets = {"plan", "chessboard"};
  const auto folder = PrintBoards(options_, dir_ / "some", {});
  ASSERT_TRUE(folder.ok());
  EXPECT_TRUE(fs::exists(dir_ / "some" / "plan.pdf") && fs::exists(dir_ / "some" / "chessboard.pdf"));
  EXPECT_FALSE(fs::exists(dir_ / "some" / "first-estimates.pdf"));
}

TEST_F(BoardTest, EachDeviceOfTheRepositoryHasTargets) {
  for (const char* name : {"devices/four-lasers.toml", "devices/two-lasers-70.toml"}) {
    options_.device_path = name;
    const auto report = PrintBoards(options_, dir_ / "targets", {});
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_TRUE(report->warnings.empty()) << report->warnings.front();
    EXPECT_EQ(report->sheets.size(), 3U);
  }
}

TEST_F(BoardTest, LinesThatTheDetectorWouldMergeAreToldApartByAWarning) {
  std::string text = PerfectDevice();
  text.replace(text.find("[0.0, 0.0, 395.0]"), 17, "[-10.0, 0.0, 395.0]");
  ASSERT_TRUE(WriteFile(options_.device_path, text).ok());
  const auto report = PrintBoards(options_, dir_ / "targets", {});
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->warnings.size(), 1U);
  EXPECT_THAT(report->warnings[0], testing::HasSubstr("lasers 0 and 1"));
}

// What cannot be printed is refused with one sentence, and leaves nothing behind.
TEST_F(BoardTest, DevicesWhoseTargetsCannotBePrinted) {
  const std::string lights = "\n[[laser]]\n[[led]]\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[board]\ncolumns = 60\nrows = 60\nsquare_mm = 200" + lights, "12600 x 12600 mm"},
      {"[board]\nsquare_mm = 25" + lights, "it fits on A2, or on several pages with --tile-chessboard"},
      {"[board]\nsquare_mm = nan" + lights, "square_mm"},
      {"[camera]\nlook_at_mm = [9000.0, 0.0, 380.0]" + lights, "look_at_mm"},
      {"[camera]\nposition_mm = [0.0, 0.0, 3000.0]\nfocal_length_px = 400.0" + lights,
       "leave it out with --sheets"},
      {"[calibration]\nbox_heights_mm = [500.0]" + lights, "look_at_mm"},
  };
  for (const auto& [text, culprit] : cases) {
    ASSERT_TRUE(WriteFile(options_.device_path, text).ok());
    for (const char* out : {"out", "out.pdf"}) {
      const auto report = PrintBoards(options_, dir_ / out, {});
      ASSERT_FALSE(report.ok()) << text;
      EXPECT_EQ(report.error().code, ErrorCode::kBadInput);
      EXPECT_THAT(report.error().message, testing::HasSubstr(culprit));
      EXPECT_FALSE(fs::exists(dir_ / out));
    }
  }
}

TEST_F(BoardTest, ChessboardOnSeveralPagesWhenAsked) {
  std::string text = PerfectDevice() + "[board]\nsquare_mm = 25.0\n";
  ASSERT_TRUE(WriteFile(options_.device_path, text).ok());
  EXPECT_FALSE(PrintBoards(options_, dir_ / "out.pdf", {}).ok());
  options_.tile_chessboard = true;
  const auto report = PrintBoards(options_, dir_ / "out.pdf", {});
  ASSERT_TRUE(report.ok());
  EXPECT_GT(report->sheets.front().pages, 1);
}

TEST_F(BoardTest, AnInterruptLeavesNothing) {
  std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  for (const char* out : {"out", "out.pdf"}) {
    const auto report = PrintBoards(options_, dir_ / out, context);
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.error().code, ErrorCode::kCancelled);
    EXPECT_FALSE(fs::exists(dir_ / out));
  }
}

}  // namespace
}  // namespace dorsum
