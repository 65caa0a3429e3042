// SPDX-License-Identifier: Apache-2.0
#include "report/printed_targets.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dorsum {
namespace {

constexpr const char* kPrintNote = "Print at 100 %, with no fit to page, and measure both rulers.";

std::string Mm(double value) {
  std::ostringstream text;
  text.precision(7);
  text << std::round(100.0 * value) / 100.0 + 0.0;
  return text.str();
}

std::string Size(double width, double height) { return Mm(width) + " x " + Mm(height) + " mm"; }

void DrawChessboard(const BoardDesign& board, PrintedDocument& document) {
  const double s = board.square_mm;
  const Eigen::Vector2d corner(-0.5 * s * (board.columns + 1), -0.5 * s * (board.rows + 1));
  for (int r = 0; r <= board.rows; ++r) {
    for (int c = 0; c <= board.columns; ++c) {
      if ((r + c) % 2 != 0) continue;
      const Eigen::Vector2d at = corner + s * Eigen::Vector2d(c, r);
      document.FillBox({at, at + s * Eigen::Vector2d::Ones()}, 0.0);
    }
  }
  const PrintedLine thin{0.2, 0.0, 0.0};
  const Eigen::Vector2d half = -corner + s * Eigen::Vector2d::Ones();
  const double mark = std::min(4.0, 0.25 * s);
  for (const double side : {-1.0, 1.0}) {
    document.Line({0.0, side * half.y()}, {0.0, side * (half.y() - mark)}, thin);
    document.Line({side * half.x(), 0.0}, {side * (half.x() - mark), 0.0}, thin);
    for (const double other : {-1.0, 1.0}) {  // corners, to cut the sheet out
      const Eigen::Vector2d at(side * half.x(), other * half.y());
      document.Line(at, at - Eigen::Vector2d(side * mark, 0.0), thin);
      document.Line(at, at - Eigen::Vector2d(0.0, other * mark), thin);
    }
  }
}

// From `bottom` to `top`, both y.
void DrawCentralLine(const CentralLine& line, double bottom, double top, const PrintedLine& style,
                     PrintedDocument& document) {
  const auto at = [&](double y) {
    return Eigen::Vector2d(line.x_mm + y * line.direction.x() / line.direction.y(), y);
  };
  document.Line(at(bottom), at(top), style);
}

std::string LinesInWords(const std::vector<CentralLine>& lines) {
  std::string lasers, places;
  const double origin = lines.size() > 1 ? lines[1].x_mm : lines.front().x_mm;
  for (const CentralLine& line : lines) {
    const char* comma = lasers.empty() ? "" : ", ";
    lasers += comma + std::to_string(line.laser);
    places += comma + Mm(line.x_mm - origin);
  }
  return (lines.size() > 1 ? "Lines of lasers " : "Line of laser ") + lasers + " at x = " + places + " mm";
}

constexpr double kPlanBorderMm = 8.0;

void DrawCross(const Eigen::Vector2d& at, double size, PrintedDocument& document) {
  const PrintedLine thin{0.25, 0.0, 0.0};
  document.Line(at - Eigen::Vector2d(size, 0.0), at + Eigen::Vector2d(size, 0.0), thin);
  document.Line(at - Eigen::Vector2d(0.0, size), at + Eigen::Vector2d(0.0, size), thin);
}

void DrawPlan(const BackplanePlan& plan, const Eigen::AlignedBox2d& field, PrintedDocument& document) {
  document.Polygon(plan.field, {0.4, 0.0, 0.0});
  document.Text("the camera's view of the backplane", field.min() + Eigen::Vector2d(0.0, -4.5),
                {.size_mm = 2.6});
  for (const BackplanePlan::Box& box : plan.boxes) {
    const Eigen::Vector2d a = box.foot.min(), b = box.foot.max();
    document.Polygon({a, {b.x(), a.y()}, b, {a.x(), b.y()}}, {0.2, 0.35, 2.0});
    document.Text("box " + Mm(box.height_mm) + " mm", {b.x() - 1.0, a.y() + 20.0},
                  {.size_mm = 1.9, .grey = 0.35, .upwards = true});
  }
  for (const CentralLine& line : plan.lines) {
    DrawCentralLine(line, field.min().y(), field.max().y(), {0.25, 0.5, 0.0}, document);
    document.Text(std::to_string(line.laser), {line.x_mm, field.max().y() + 2.0},
                  {.size_mm = 3.0, .align = PrintAlign::kCentre});
  }
  const double origin = plan.lines.size() > 1 ? plan.lines[1].x_mm : plan.lines.front().x_mm;
  DrawCross({origin, 0.0}, 10.0, document);
  document.Text("origin", {origin - 1.5, 1.5}, {.align = PrintAlign::kRight});
  if (field.contains(plan.camera_foot)) {
    DrawCross(plan.camera_foot, 6.0, document);
    document.Text("below the camera", plan.camera_foot + Eigen::Vector2d(1.5, 1.5), {});
  }
}

}  // namespace

PrintedSheet ChessboardTarget(const std::string& device, const BoardDesign& board) {
  PrintedSheet sheet;
  const double s = board.square_mm;
  sheet.name = "chessboard";
  sheet.title = "Dorsum chessboard for \"" + device + "\": " + std::to_string(board.columns) + " x " +
                std::to_string(board.rows) + " inner corners, squares of " + Mm(s) + " mm, " +
                Size(s * (board.columns + 1), s * (board.rows + 1)) + " in all";
  sheet.notes = {std::string(kPrintNote) +
                     " A board that is 1 % too large or too small makes every height wrong by 1 %.",
                 "Glue it on a flat, stiff plate and keep the white margin of " + Mm(s) +
                     " mm; the marks in the margin show the middle."};
  sheet.size_mm = s * Eigen::Vector2d(board.columns + 3, board.rows + 3);
  sheet.may_tile = false;
  sheet.draw = [board](PrintedDocument& document) { DrawChessboard(board, document); };
  return sheet;
}

PrintedSheet FirstEstimatesTarget(const std::string& device, const std::vector<CentralLine>& lines,
                                  double length_mm) {
  PrintedSheet sheet;
  Eigen::AlignedBox1d across;
  for (const CentralLine& line : lines) {
    const double lean = std::abs(0.5 * length_mm * line.direction.x() / line.direction.y());
    across.extend(Eigen::Matrix<double, 1, 1>(line.x_mm - lean));
    across.extend(Eigen::Matrix<double, 1, 1>(line.x_mm + lean));
  }
  const double middle = across.center()(0);
  sheet.name = "first-estimates";
  sheet.title = "Dorsum laser calibration plane (laserFirstEstimates) for \"" + device + "\"";
  sheet.notes = {
      LinesInWords(lines) + ", " + Mm(length_mm) + " mm long.", kPrintNote,
      "Lay it flat on the backplane with the numbers up in the picture and each line where the brightest "
      "stripe of its laser runs; it need not be exact."};
  sheet.size_mm = {across.sizes()(0) + 20.0, length_mm + 16.0};
  sheet.words_grey = 0.7;
  sheet.sparse_rulers = true;
  sheet.draw = [lines, length_mm, middle](PrintedDocument& document) {
    for (CentralLine line : lines) {
      line.x_mm -= middle;
      DrawCentralLine(line, -0.5 * length_mm, 0.5 * length_mm, {1.0, 0.0, 0.0}, document);
      const double top = 0.5 * length_mm;
      document.Text(std::to_string(line.laser),
                    {line.x_mm + top * line.direction.x() / line.direction.y(), top + 3.0},
                    {.size_mm = 3.5, .grey = 0.7, .align = PrintAlign::kCentre});
    }
  };
  return sheet;
}

PrintedSheet PlanTarget(const std::string& device, const BackplanePlan& plan) {
  Eigen::AlignedBox2d field;
  for (const Eigen::Vector2d& p : plan.field) field.extend(p);
  PrintedSheet sheet;
  sheet.name = "plan";
  sheet.title = "Dorsum plan of the backplane for \"" + device + "\", seen from above";
  std::string boxes;
  for (const BackplanePlan::Box& box : plan.boxes) {
    boxes += (boxes.empty() ? "" : ", ") + Mm(box.height_mm) +
             " mm: " + Size(std::ceil(box.foot.sizes().x()), std::ceil(box.foot.sizes().y()));
  }
  sheet.notes = {kPrintNote,
                 "For setting up only: take it away before calibrating. Backplane: white, matt, at least " +
                     Size(std::ceil(field.sizes().x()), std::ceil(field.sizes().y())) +
                     "; calibration object " + Mm(plan.object_height_mm) +
                     " mm high: white flat top of at least " +
                     Size(std::ceil(plan.object_size_mm.x()), std::ceil(plan.object_size_mm.y())) +
                     "; boxes with a flat matt top, by height: " + boxes + "."};
  sheet.size_mm = field.sizes() + 2.0 * kPlanBorderMm * Eigen::Vector2d::Ones();
  sheet.draw = [plan, field](PrintedDocument& document) {
    document.BeginFrame(-field.center(), {field.min() - 20.0 * Eigen::Vector2d::Ones(),
                                          field.max() + 20.0 * Eigen::Vector2d::Ones()});
    DrawPlan(plan, field, document);
    document.EndFrame();
  };
  return sheet;
}

}  // namespace dorsum
