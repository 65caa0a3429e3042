// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <unistd.h>

#include "base/files.h"
#include "report/printed_sheet.h"

namespace dorsum {

// The pages of a PDF in grey at this resolution, as an independent program (pdftoppm) draws them.
inline std::vector<cv::Mat> DrawnPages(const std::string& pdf, int dpi) {
  const std::filesystem::path dir =
      std::filesystem::path(::testing::TempDir()) / ("dorsum_pdf_" + std::to_string(getpid()));
  std::filesystem::create_directories(dir);
  EXPECT_TRUE(WriteFile(dir / "test.pdf", pdf).ok());
  const std::string command = "pdftoppm -gray -r " + std::to_string(dpi) + " '" +
                              (dir / "test.pdf").string() + "' '" + (dir / "page").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << "pdftoppm of poppler-utils is needed here";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(dir)) {
    if (entry.path().extension() == ".pgm") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<cv::Mat> pages;
  pages.reserve(files.size());
  for (const auto& file : files) pages.push_back(cv::imread(file, cv::IMREAD_GRAYSCALE));
  std::filesystem::remove_all(dir);
  return pages;
}

inline std::string SheetPdf(const PrintedSheet& sheet, const SheetLayout& layout) {
  PrintedDocument document(sheet.title);
  DrawSheet(sheet, layout, &document);
  return document.Finish().value();
}

// The lower left corner of the area for the sheet on its page, mm from the page's.
inline Eigen::Vector2d TileCorner(const SheetLayout& layout) {
  return {kUnprintedMm + kRulerStripMm, kUnprintedMm + layout.words_mm + kRulerStripMm};
}

// Where a point of a page, mm from its lower left corner, lies in its picture.
inline cv::Point2d PixelOf(const Eigen::Vector2d& mm, const SheetLayout& layout, double px_per_mm) {
  return {mm.x() * px_per_mm - 0.5, (layout.page.height_mm - mm.y()) * px_per_mm - 0.5};
}

}  // namespace dorsum
