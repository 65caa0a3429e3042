// SPDX-License-Identifier: Apache-2.0
#include "report/printed_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/printed_pdf_test.h"

namespace dorsum {
namespace {

PrintedSheet Blank(double width_mm, double height_mm) {
  PrintedSheet sheet;
  sheet.name = "blank";
  sheet.title = "A blank sheet";
  sheet.notes = {"Print at 100 %."};
  sheet.size_mm = {width_mm, height_mm};
  sheet.draw = [](PrintedDocument&) {};
  return sheet;
}

TEST(PrintedSheetTest, ASheetIsTurnedWhereThatSavesPages) {
  const Result<SheetLayout> wide = LayOutSheet(Blank(250.0, 150.0), Paper{});
  ASSERT_TRUE(wide.ok());
  EXPECT_EQ(wide->Pages(), 1);
  EXPECT_EQ(wide->page.width_mm, 297.0);
  const Result<SheetLayout> tall = LayOutSheet(Blank(150.0, 240.0), Paper{});
  ASSERT_TRUE(tall.ok());
  EXPECT_EQ(tall->Pages(), 1);
  EXPECT_EQ(tall->page.width_mm, 210.0);
}

// Every point of a tiled sheet is on a page, and neighbours share a strip of the overlap's width.
TEST(PrintedSheetTest, TilesCoverTheWholeSheet) {
  for (const auto& [width, height] :
       {std::pair{400.0, 300.0}, {179.5, 700.0}, {263.1, 10.0}, {900.0, 900.0}}) {
    const Result<SheetLayout> layout = LayOutSheet(Blank(width, height), Paper{});
    ASSERT_TRUE(layout.ok()) << layout.error().message;
    const auto covers = [](int tiles, double tile, double length) {
      const double all = tiles * tile - (tiles - 1) * kTileOverlapMm;
      return all >= length - 1e-9 && (tiles == 1 || all - tile + kTileOverlapMm < length);
    };
    EXPECT_TRUE(covers(layout->columns, layout->tile_mm.x(), width)) << width << " x " << height;
    EXPECT_TRUE(covers(layout->rows, layout->tile_mm.y(), height)) << width << " x " << height;
  }
}

// A sheet full of ink, put together from its pages again, has its size.
TEST(PrintedSheetTest, TiledPagesTogetherHoldTheSheetOnce) {
  PrintedSheet sheet = Blank(300.0, 250.0);
  sheet.words_grey = 1.0;  // nothing but the sheet
  sheet.draw = [](PrintedDocument& document) {
    document.FillBox({Eigen::Vector2d(-150.0, -125.0), Eigen::Vector2d(150.0, 125.0)}, 0.0);
  };
  const SheetLayout layout = LayOutSheet(sheet, Paper{}).value();
  ASSERT_GT(layout.Pages(), 1);
  const std::vector<cv::Mat> pages = DrawnPages(SheetPdf(sheet, layout), 127);
  ASSERT_EQ(pages.size(), static_cast<std::size_t>(layout.Pages()));
  const Eigen::Vector2d step = layout.tile_mm - kTileOverlapMm * Eigen::Vector2d::Ones();
  const Eigen::Vector2d corner = TileCorner(layout);
  double dark = 0.0;  // mm2, the first of two neighbours without the strip that they share
  for (int i = 0; i < layout.Pages(); ++i) {
    const int column = i % layout.columns, row = i / layout.columns;
    const double width = column + 1 < layout.columns ? step.x() : layout.tile_mm.x();
    const double from = row + 1 < layout.rows ? corner.y() + kTileOverlapMm : corner.y();
    const cv::Point2d a = PixelOf({corner.x(), corner.y() + layout.tile_mm.y()}, layout, 5.0);
    const cv::Point2d b = PixelOf({corner.x() + width, from}, layout, 5.0);
    const cv::Mat ink =
        pages[static_cast<std::size_t>(i)](
            cv::Rect(cv::Point(a + cv::Point2d(0.5, 0.5)), cv::Point(b + cv::Point2d(0.5, 0.5)))) < 128;
    dark += cv::countNonZero(ink) / 25.0;
  }
  EXPECT_NEAR(dark, 300.0 * 250.0, 300.0);  // less the crosses on the seams, which are grey
}

TEST(PrintedSheetTest, WhatMayNotBeTiledIsRefusedWithWhatFits) {
  PrintedSheet sheet = Blank(250.0, 250.0);
  sheet.may_tile = false;
  const Result<SheetLayout> small = LayOutSheet(sheet, Paper{});
  ASSERT_FALSE(small.ok());
  EXPECT_EQ(small.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(small.error().message,
              testing::AllOf(testing::HasSubstr("250 x 250 mm"), testing::HasSubstr("it fits on A3")));
  sheet.size_mm = {13000.0, 13000.0};
  const Result<SheetLayout> absurd = LayOutSheet(sheet, Paper{});
  ASSERT_FALSE(absurd.ok());
  EXPECT_THAT(absurd.error().message, testing::HasSubstr("no paper with a name"));
}

TEST(PrintedSheetTest, AbsurdSizesAreRefusedNotPrinted) {
  for (const double size : {3000.0, 1e6, 1e12}) {
    const Result<SheetLayout> layout = LayOutSheet(Blank(size, size), Paper{});
    ASSERT_FALSE(layout.ok()) << size;
    EXPECT_EQ(layout.error().code, ErrorCode::kBadInput);
  }
  PrintedSheet wordy = Blank(30.0, 30.0);
  for (int i = 0; i < 40; ++i) wordy.notes.emplace_back("Words that leave no room for the sheet itself.");
  EXPECT_FALSE(LayOutSheet(wordy, ParsePaper("100x100").value()).ok());
}

// The first and the last mark of the rulers on a page: `pixels` runs along one of them, across its marks.
double RulerLength(const cv::Mat& pixels, double px_per_mm, int* marks) {
  std::vector<double> middles;
  double weight = 0.0, moment = 0.0;
  const cv::Mat row = pixels.reshape(1, 1);
  for (int i = 0; i < row.cols; ++i) {
    const double ink = 255.0 - row.at<std::uint8_t>(i);
    if (ink > 40.0) {
      weight += ink;
      moment += ink * i;
    } else if (weight > 0.0) {
      middles.push_back(moment / weight);
      weight = moment = 0.0;
    }
  }
  *marks = static_cast<int>(middles.size());
  return middles.size() < 2 ? 0.0 : (middles.back() - middles.front()) / px_per_mm;
}

TEST(PrintedSheetTest, BothRulersAreAsLongAsTheySay) {
  const PrintedSheet sheet = Blank(250.0, 150.0);
  const SheetLayout layout = LayOutSheet(sheet, Paper{}).value();
  const double px_per_mm = 600.0 / 25.4;
  const cv::Mat page = DrawnPages(SheetPdf(sheet, layout), 600).at(0);
  const Eigen::Vector2d corner = TileCorner(layout);
  int marks = 0;
  const auto y = static_cast<int>(PixelOf({0.0, corner.y() - 2.5}, layout, px_per_mm).y);
  const int left = static_cast<int>(PixelOf({corner.x() - 0.5, 0.0}, layout, px_per_mm).x);
  EXPECT_NEAR(RulerLength(page.row(y).colRange(left, page.cols).clone(), px_per_mm, &marks), 200.0, 0.02);
  EXPECT_EQ(marks, 201);
  const auto x = static_cast<int>(PixelOf({corner.x() - 2.5, 0.0}, layout, px_per_mm).x);
  const int above = static_cast<int>(PixelOf({0.0, corner.y() - 0.5}, layout, px_per_mm).y);
  const cv::Mat column = page.col(x).rowRange(0, above).clone();
  const double upright = RulerLength(column, px_per_mm, &marks);
  EXPECT_NEAR(upright, marks - 1, 0.02);
  EXPECT_EQ(marks, 161);
}

}  // namespace
}  // namespace dorsum
