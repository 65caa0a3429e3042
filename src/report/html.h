// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

#include "calibration/verdict.h"

namespace dorsum {

// Text made safe to stand in HTML, as content or in a quoted attribute.
std::string EscapeHtml(std::string_view text);

// A picture as a data: URI. Photos and shaded surfaces as JPEG, drawings with text and lines as PNG.
enum class ImageKind { kPhoto, kDrawing };
std::string ImageUri(const cv::Mat& picture, ImageKind kind);

struct HtmlFigure {
  cv::Mat picture;  // an empty one shows the caption alone
  ImageKind kind = ImageKind::kPhoto;
  std::string title;         // what it is
  std::string caption = {};  // what to look for, in plain words
  bool wide = false;         // over the page's whole width
};

struct HtmlCell {
  HtmlCell(std::string t) : text(std::move(t)) {}  // NOLINT(google-explicit-constructor)
  HtmlCell(const char* t) : text(t) {}             // NOLINT(google-explicit-constructor)
  HtmlCell(std::string t, double bar_share) : text(std::move(t)), bar(bar_share) {}
  std::string text;
  std::optional<double> bar;  // a bar of this share of the cell's width, 0 to 1, beside the text
};

struct HtmlTable {
  std::vector<std::string> header;
  std::vector<std::vector<HtmlCell>> rows;
  std::size_t first_number = 1;  // columns from here on hold numbers and are right-aligned
  std::string caption;
};

// One number that a reader wants first.
struct HtmlFact {
  std::string name, value, unit;
};

// Writes one self-contained page: inline style, embedded pictures, no script, nothing from a network. All
// text that comes in is escaped. The same calls give the same bytes.
class HtmlPage {
 public:
  HtmlPage(const std::string& title, const std::string& subtitle);

  void Section(const std::string& heading, const std::string& intro = "");
  void Paragraph(const std::string& text);
  void Facts(const std::vector<HtmlFact>& facts);
  void Warnings(const std::vector<std::string>& warnings);
  void Verdicts(const std::vector<PartReport>& parts);
  // Side by side where the screen is wide enough, at most `columns` (2 or 3) in a row. Those with neither
  // picture nor caption are left out.
  void Figures(const std::vector<HtmlFigure>& figures, int columns = 2);
  void Table(const HtmlTable& table);
  std::string Finish(const std::string& footer) const;

 private:
  void AddFigure(const HtmlFigure& figure);

  std::string title_, body_;
  int figures_ = 0;
};

}  // namespace dorsum
