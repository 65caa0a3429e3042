// SPDX-License-Identifier: Apache-2.0
#include "report/printed_targets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "calibration/chessboard.h"
#include "report/printed_pdf_test.h"

namespace dorsum {
namespace {

// The chessboard of a device on A4 or A3, as the detector of the calibration finds it in the drawn page.
void ExpectSquares(const BoardDesign& board, const Paper& paper) {
  SCOPED_TRACE(std::to_string(board.columns) + " x " + std::to_string(board.rows));
  const PrintedSheet sheet = ChessboardTarget("test", board);
  const Result<SheetLayout> layout = LayOutSheet(sheet, paper);
  ASSERT_TRUE(layout.ok()) << layout.error().message;
  // Drawn finely and averaged, since pdftoppm moves edges to whole pixels.
  const double px_per_mm = 150.0 / 25.4;
  std::vector<cv::Mat> pages = DrawnPages(SheetPdf(sheet, *layout), 600);
  ASSERT_EQ(pages.size(), 1U);
  cv::resize(pages[0], pages[0], {}, 0.25, 0.25, cv::INTER_AREA);
  EXPECT_NEAR(pages[0].cols / px_per_mm, layout->page.width_mm, 0.2);
  EXPECT_NEAR(pages[0].rows / px_per_mm, layout->page.height_mm, 0.2);
  const cv::Size inner(board.columns, board.rows);
  const auto corners = FindChessboard(pages[0], inner);
  ASSERT_TRUE(corners.has_value()) << "the rulers, words or marks disturb the detector";
  const Eigen::Vector2d middle = TileCorner(*layout) + 0.5 * layout->tile_mm;
  const std::vector<cv::Point3f> truth = ChessboardPoints(inner, board.square_mm);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    // Both count rows down the page.
    const cv::Point2d expected =
        PixelOf(middle + Eigen::Vector2d(truth[i].x, -truth[i].y), *layout, px_per_mm);
    const cv::Point2d found((*corners)[i]);
    EXPECT_LT(cv::norm(found - expected) / px_per_mm, 0.05) << "corner " << i;
  }
}

TEST(PrintedTargetsTest, TheDetectorFindsEverySquareAtTrueScale) {
  ExpectSquares({}, Paper{});
  ExpectSquares({6, 9, 12.5}, Paper{});
  ExpectSquares({11, 8, 20.0}, ParsePaper("A3").value());
  ExpectSquares({3, 4, 25.0}, ParsePaper("Letter").value());
}

TEST(PrintedTargetsTest, TheChessboardIsNotTiledUnlessAsked) {
  PrintedSheet sheet = ChessboardTarget("test", {11, 8, 25.0});
  EXPECT_FALSE(LayOutSheet(sheet, Paper{}).ok());
  sheet.may_tile = true;
  EXPECT_GT(LayOutSheet(sheet, Paper{})->Pages(), 1);
}

// Middles of the black runs in a row of pixels, px.
std::vector<double> BlackRuns(const cv::Mat& page, int row) {
  std::vector<double> middles;
  int first = -1;
  for (int u = 0; u < page.cols; ++u) {
    const bool black = page.at<std::uint8_t>(row, u) < 100;
    if (black && first < 0) first = u;
    if (!black && first >= 0) {
      middles.push_back(0.5 * (first + u - 1));
      first = -1;
    }
  }
  return middles;
}

TEST(PrintedTargetsTest, TheLinesStandWhereTheyShouldAndLeanAsTheyShould) {
  const Eigen::Vector2d lean = Eigen::Vector2d(0.1, 1.0).normalized();
  const PrintedSheet sheet = FirstEstimatesTarget(
      "test", {{0, -11.15, Eigen::Vector2d::UnitY()}, {1, 0.0, Eigen::Vector2d::UnitY()}, {2, 30.5, lean}},
      130.0);
  const SheetLayout layout = LayOutSheet(sheet, Paper{}).value();
  const double px_per_mm = 300.0 / 25.4;
  const cv::Mat page = DrawnPages(SheetPdf(sheet, layout), 300).at(0);
  const Eigen::Vector2d middle = TileCorner(layout) + 0.5 * layout.tile_mm;
  for (const double y : {-60.0, 0.0, 60.0}) {
    const cv::Point2d at = PixelOf(middle + Eigen::Vector2d(0.0, y), layout, px_per_mm);
    const std::vector<double> lines = BlackRuns(page, static_cast<int>(std::lround(at.y)));
    ASSERT_EQ(lines.size(), 3U) << y;
    EXPECT_NEAR((lines[1] - lines[0]) / px_per_mm, 11.15, 0.1);
    EXPECT_NEAR((lines[2] - lines[1]) / px_per_mm, 30.5 + 0.1 * y, 0.1);
  }
  // The words and rulers are too light to be taken for lines.
  for (const double y : {-70.0, 70.0}) {
    const cv::Point2d at = PixelOf(middle + Eigen::Vector2d(0.0, y), layout, px_per_mm);
    EXPECT_TRUE(BlackRuns(page, static_cast<int>(std::lround(at.y))).empty()) << y;
  }
  const int words = static_cast<int>(PixelOf({0.0, TileCorner(layout).y() - 2.0}, layout, px_per_mm).y);
  for (int row = words; row < page.rows; ++row) ASSERT_TRUE(BlackRuns(page, row).empty());
}

TEST(PrintedTargetsTest, ThePlanNamesTheSizesOfWhatIsToBeBuilt) {
  BackplanePlan plan;
  plan.field = {{-150.0, -100.0}, {160.0, -110.0}, {160.0, 110.0}, {-150.0, 100.0}};
  plan.lines = {{0, 0.0, Eigen::Vector2d::UnitY()}};
  plan.camera_foot = {-118.0, 0.0};
  plan.boxes = {{20.0, {Eigen::Vector2d(-120.0, -70.0), Eigen::Vector2d(130.0, 70.0)}}};
  plan.object_height_mm = 50.0;
  plan.object_size_mm = {300.0, 240.0};
  const PrintedSheet sheet = PlanTarget("test", plan);
  std::string words;
  for (const std::string& note : sheet.notes) words += note;
  for (const char* size : {"310 x 220 mm", "300 x 240 mm", "20 mm: 250 x 140 mm"}) {
    EXPECT_THAT(words, testing::HasSubstr(size));
  }
  const SheetLayout layout = LayOutSheet(sheet, ParsePaper("A3").value()).value();
  ASSERT_EQ(layout.Pages(), 1);
  const cv::Mat page = DrawnPages(SheetPdf(sheet, layout), 127).at(0);
  // The right edge of the field, 310 mm from the left one.
  const cv::Point2d left =
      PixelOf(TileCorner(layout) + 0.5 * layout.tile_mm - Eigen::Vector2d(155.0, 90.0), layout, 5.0);
  const std::vector<double> edges = BlackRuns(page, static_cast<int>(std::lround(left.y)));
  ASSERT_GE(edges.size(), 2U);
  EXPECT_NEAR((edges.back() - left.x) / 5.0, 310.0, 0.3);
}

}  // namespace
}  // namespace dorsum
