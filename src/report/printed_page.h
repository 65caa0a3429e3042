// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/result.h"

namespace dorsum {

// A sheet of paper, mm.
struct Paper {
  std::string name = "A4";
  double width_mm = 210.0, height_mm = 297.0;
};

// "A4", "A3", "A2", "Letter", "Legal" in any case, or "300x400" in mm, each side 100 to 2000. A usage error
// names what is allowed.
Result<Paper> ParsePaper(const std::string& text);

// The papers that ParsePaper knows by name, small ones first.
const std::vector<Paper>& KnownPapers();

enum class PrintAlign { kLeft, kCentre, kRight };

struct PrintedText {
  double size_mm = 2.3;  // height of capital letters
  double grey = 0.0;     // 0 black to 1 white
  PrintAlign align = PrintAlign::kLeft;
  bool bold = false;
  bool upwards = false;  // runs from bottom to top
};

struct PrintedLine {
  double width_mm = 0.2;
  double grey = 0.0;
  double dash_mm = 0.0;  // length of dashes and gaps; 0: a full line
};

// A document of pages at true scale, drawn in millimetres with x to the right and y up. Its bytes depend on
// what is drawn alone: they hold no date, and the letters are drawn by cairo's own font, which needs none to
// be installed. That font has ASCII only; other characters become question marks.
class PrintedDocument {
 public:
  explicit PrintedDocument(std::string_view title);
  ~PrintedDocument();
  PrintedDocument(const PrintedDocument&) = delete;
  PrintedDocument& operator=(const PrintedDocument&) = delete;

  // Begins a page whose frame has its origin at the lower left corner.
  void BeginPage(double width_mm, double height_mm);
  // From here to EndFrame() the origin is at `origin` of the frame around, and nothing is drawn outside
  // `clip` (of the new frame).
  void BeginFrame(const Eigen::Vector2d& origin, const Eigen::AlignedBox2d& clip);
  void EndFrame();

  void Line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const PrintedLine& line);
  void Polygon(const std::vector<Eigen::Vector2d>& points, const PrintedLine& line);
  void FillBox(const Eigen::AlignedBox2d& box, double grey);
  // `at` is the left end, middle or right end on the baseline.
  void Text(std::string_view text, const Eigen::Vector2d& at, const PrintedText& style);
  double TextWidth(std::string_view text, const PrintedText& style);
  // The words of a text in lines that are at most so wide.
  std::vector<std::string> Wrap(const std::string& text, double width_mm, const PrintedText& style);

  int pages() const;
  // The PDF; to be called once, when all is drawn.
  Result<std::string> Finish();

 private:
  struct Canvas;
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace dorsum
