// SPDX-License-Identifier: Apache-2.0
#include "report/printed_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace dorsum {
namespace {

constexpr int kMostPages = 64;
constexpr double kLineMm = 4.3;            // from one line of words to the next
constexpr double kLongestRulerMm = 200.0;  // on which a millimetre is half a percent

std::string Mm(double value) {
  std::ostringstream text;
  text.precision(6);
  text << std::round(100.0 * value) / 100.0;
  return text.str();
}

PrintedText Words(const PrintedSheet& sheet, bool bold = false) {
  PrintedText style;
  style.grey = sheet.words_grey;
  style.bold = bold;
  return style;
}

// Title and notes in lines of the page's width.
struct WrappedWords {
  std::vector<std::string> title, notes;
  double Height() const { return kLineMm * static_cast<double>(title.size() + notes.size()); }
};

WrappedWords WrapWords(const PrintedSheet& sheet, double width_mm, const std::string& page,
                       PrintedDocument* document) {
  WrappedWords words;
  words.title = document->Wrap(sheet.title + page, width_mm, Words(sheet, true));
  for (const std::string& note : sheet.notes) {
    for (std::string& line : document->Wrap(note, width_mm, Words(sheet))) {
      words.notes.push_back(std::move(line));
    }
  }
  return words;
}

std::string PageText(const SheetLayout& layout, int column, int row) {
  if (layout.Pages() == 1) return "";
  return ": column " + std::to_string(column + 1) + " of " + std::to_string(layout.columns) + ", row " +
         std::to_string(row + 1) + " of " + std::to_string(layout.rows) +
         " from the top; cut at the crosses and glue so that they meet";
}

int TilesFor(double length, double tile) {
  if (length <= tile) return 1;
  const double tiles = std::ceil((length - kTileOverlapMm) / (tile - kTileOverlapMm) - 1e-9);
  return static_cast<int>(std::min(tiles, 1000.0));
}

std::optional<SheetLayout> LayOutOn(const PrintedSheet& sheet, const Paper& page, PrintedDocument* document) {
  SheetLayout layout;
  layout.page = page;
  const double width = page.width_mm - 2.0 * kUnprintedMm;
  // The longest that the page's number can make the title.
  SheetLayout most;
  most.columns = most.rows = 99;
  const std::string number = sheet.may_tile ? PageText(most, 98, 98) : "";
  layout.words_mm = WrapWords(sheet, width, number, document).Height();
  layout.tile_mm = {width - kRulerStripMm,
                    page.height_mm - 2.0 * kUnprintedMm - kRulerStripMm - layout.words_mm};
  if (layout.tile_mm.minCoeff() < 3.0 * kTileOverlapMm) return std::nullopt;
  layout.columns = TilesFor(sheet.size_mm.x(), layout.tile_mm.x());
  layout.rows = TilesFor(sheet.size_mm.y(), layout.tile_mm.y());
  return layout;
}

std::optional<SheetLayout> BestLayout(const PrintedSheet& sheet, const Paper& paper) {
  PrintedDocument measure("");  // widths of words alone
  const Paper turned{paper.name, paper.height_mm, paper.width_mm};
  auto upright = LayOutOn(sheet, paper, &measure), across = LayOutOn(sheet, turned, &measure);
  if (!upright || (across && across->Pages() < upright->Pages())) return across;
  return upright;
}

// Marks from `from` in steps of 1 mm, or 10 mm where they are to be sparse; the numbers every 10 or 20 mm.
void DrawRuler(const PrintedSheet& sheet, const Eigen::Vector2d& from, const Eigen::Vector2d& along,
               double length, PrintedDocument* document) {
  const Eigen::Vector2d across(-along.y(), along.x());
  const bool upwards = along.y() > 0.5;
  const Eigen::Vector2d out = upwards ? across : Eigen::Vector2d(-across);  // away from the sheet
  const PrintedLine thin{0.15, sheet.words_grey, 0.0};
  const int step = sheet.sparse_rulers ? 10 : 1;
  for (int mm = 0; mm <= static_cast<int>(length); mm += step) {
    const double size = mm % 10 == 0 ? 4.0 : (mm % 5 == 0 ? 3.0 : 2.0);
    const Eigen::Vector2d at = from + mm * along;
    document->Line(at, at + size * out, thin);
    if (mm % 20 != 0) continue;
    PrintedText number = Words(sheet);
    number.size_mm = 1.9;
    number.align = PrintAlign::kCentre;
    number.upwards = upwards;
    const double gap = upwards ? 4.8 : 4.8 + number.size_mm;
    document->Text(mm == 0 ? "0 mm" : std::to_string(mm), at + gap * out, number);
  }
  if (!sheet.sparse_rulers) document->Line(from, from + length * along, thin);
}

double RulerLength(double room) { return std::min(kLongestRulerMm, 10.0 * std::floor((room - 4.0) / 10.0)); }

// Crosses that two neighbouring parts share: at both ends and in the middle of each seam that this part has.
void DrawSeamMarks(const PrintedSheet& sheet, const SheetLayout& layout, int column, int row,
                   const Eigen::AlignedBox2d& part, PrintedDocument* document) {
  const PrintedLine thin{0.15, std::max(0.4, sheet.words_grey), 0.0};
  const double half = 0.5 * kTileOverlapMm;
  const auto cross = [&](double x, double y) {
    document->Line({x - 3.0, y}, {x + 3.0, y}, thin);
    document->Line({x, y - 3.0}, {x, y + 3.0}, thin);
  };
  const std::array<double, 3> ys = {part.min().y() + half, part.center().y(), part.max().y() - half};
  const std::array<double, 3> xs = {part.min().x() + half, part.center().x(), part.max().x() - half};
  for (const double y : ys) {
    if (column > 0) cross(xs.front(), y);
    if (column + 1 < layout.columns) cross(xs.back(), y);
  }
  for (const double x : xs) {
    if (row > 0) cross(x, ys.back());
    if (row + 1 < layout.rows) cross(x, ys.front());
  }
}

void DrawPart(const PrintedSheet& sheet, const SheetLayout& layout, int column, int row,
              PrintedDocument* document) {
  document->BeginPage(layout.page.width_mm, layout.page.height_mm);
  const double left = kUnprintedMm, bottom = kUnprintedMm;
  const double width = layout.page.width_mm - 2.0 * kUnprintedMm;
  const WrappedWords words = WrapWords(sheet, width, PageText(layout, column, row), document);
  double y = bottom + layout.words_mm - 0.7 * kLineMm;
  for (const std::string& line : words.title) {
    document->Text(line, {left, y}, Words(sheet, true));
    y -= kLineMm;
  }
  for (const std::string& line : words.notes) {
    document->Text(line, {left, y}, Words(sheet));
    y -= kLineMm;
  }

  const Eigen::Vector2d corner(left + kRulerStripMm, bottom + layout.words_mm + kRulerStripMm);
  const Eigen::Vector2d step = layout.tile_mm - kTileOverlapMm * Eigen::Vector2d::Ones();
  const Eigen::Vector2d count(layout.columns, layout.rows);
  const Eigen::Vector2d all = step.cwiseProduct(count) + kTileOverlapMm * Eigen::Vector2d::Ones();
  const Eigen::Vector2d first =
      -0.5 * all + step.cwiseProduct(Eigen::Vector2d(column, layout.rows - 1 - row));
  const Eigen::AlignedBox2d part(first, first + layout.tile_mm);
  document->BeginFrame(corner - part.min(), part);
  sheet.draw(*document);
  DrawSeamMarks(sheet, layout, column, row, part, document);
  document->EndFrame();

  DrawRuler(sheet, corner - Eigen::Vector2d(0.0, 1.5), Eigen::Vector2d::UnitX(),
            RulerLength(layout.tile_mm.x()), document);
  DrawRuler(sheet, corner - Eigen::Vector2d(1.5, 0.0), Eigen::Vector2d::UnitY(),
            RulerLength(layout.tile_mm.y()), document);
}

// "169 x 251.8 mm upright or 269 x 156 mm across".
std::string Room(const PrintedSheet& sheet, const Paper& paper) {
  PrintedDocument measure("");
  std::string text;
  for (const bool turn : {false, true}) {
    const Paper page = turn ? Paper{paper.name, paper.height_mm, paper.width_mm} : paper;
    const auto layout = LayOutOn(sheet, page, &measure);
    if (!layout) continue;
    text += (text.empty() ? "" : " or ") + Mm(layout->tile_mm.x()) + " x " + Mm(layout->tile_mm.y()) +
            " mm " + (page.width_mm > page.height_mm ? "across" : "upright");
  }
  return text;
}

// The smallest paper with a name on which the sheet is whole.
std::string WhatFits(const PrintedSheet& sheet) {
  for (const Paper& paper : KnownPapers()) {
    const auto layout = BestLayout(sheet, paper);
    if (layout && layout->Pages() == 1) return "it fits on " + paper.name;
  }
  return "no paper with a name is large enough";
}

}  // namespace

Result<SheetLayout> LayOutSheet(const PrintedSheet& sheet, const Paper& paper) {
  const std::string what = "the " + sheet.name + " of " + Mm(sheet.size_mm.x()) + " x " +
                           Mm(sheet.size_mm.y()) + " mm does not fit on ";
  const auto layout = BestLayout(sheet, paper);
  if (!layout) {
    return BadInput(what + paper.name + ", whose words and rulers leave no room; take larger paper");
  }
  if (layout->Pages() > 1 && !sheet.may_tile) {
    return BadInput(what + "one page of " + paper.name + ", which has room for " + Room(sheet, paper) + "; " +
                    WhatFits(sheet));
  }
  if (layout->Pages() > kMostPages) {
    return BadInput(what + std::to_string(kMostPages) + " pages of " + paper.name +
                    "; check the device description, or take larger paper");
  }
  return *layout;
}

void DrawSheet(const PrintedSheet& sheet, const SheetLayout& layout, PrintedDocument* document) {
  for (int row = 0; row < layout.rows; ++row) {
    for (int column = 0; column < layout.columns; ++column) DrawPart(sheet, layout, column, row, document);
  }
}

}  // namespace dorsum
