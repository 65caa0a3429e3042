// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.h"
#include "report/printed_page.h"

namespace dorsum {

// Something to print at true scale.
struct PrintedSheet {
  std::string name;                // "chessboard": of its file
  std::string title;               // one line
  std::vector<std::string> notes;  // sentences for whoever prints and uses it
  Eigen::Vector2d size_mm = Eigen::Vector2d::Zero();
  bool may_tile = true;        // over several pages, to be glued
  double words_grey = 0.0;     // of all that the page adds: words, rulers, marks
  bool sparse_rulers = false;  // marks every 10 mm only, which no search for lines takes for one
  std::function<void(PrintedDocument&)> draw;  // in a frame with its origin in the sheet's middle
};

// How a sheet is laid out: `columns` x `rows` pages of one orientation, whose areas for the sheet are
// `tile_mm` and overlap by kTileOverlapMm.
struct SheetLayout {
  Paper page;  // turned as it is used
  int columns = 1, rows = 1;
  Eigen::Vector2d tile_mm = Eigen::Vector2d::Zero();
  double words_mm = 0.0;  // height of the words below

  int Pages() const { return columns * rows; }
};

inline constexpr double kTileOverlapMm = 10.0;
inline constexpr double kUnprintedMm = 10.0;   // border that printers leave white
inline constexpr double kRulerStripMm = 11.0;  // left and below

// The layout with the fewest pages, upright where both ways need as many. A sheet that may not be tiled and
// does not fit is an error that says what would fit; so is one of more than 64 pages.
Result<SheetLayout> LayOutSheet(const PrintedSheet& sheet, const Paper& paper);

// Draws the pages: the sheet or its part, a ruler each way, title, notes, and where the parts meet.
void DrawSheet(const PrintedSheet& sheet, const SheetLayout& layout, PrintedDocument* document);

}  // namespace dorsum
