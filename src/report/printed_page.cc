// SPDX-License-Identifier: Apache-2.0
#include "report/printed_page.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo.h>

namespace dorsum {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kLeastSideMm = 100.0, kMostSideMm = 2000.0;
constexpr double kCapitalShare = 0.667;  // height of the font's capital letters, share of its size

std::string Lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool ReadSide(std::string_view text, double* side) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *side);
  return error == std::errc() && end == text.data() + text.size() && *side >= kLeastSideMm &&
         *side <= kMostSideMm;
}

std::string AsciiOnly(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) continue;  // one question mark for a whole UTF-8 character
    out += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  return out;
}

cairo_status_t Append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

const std::vector<Paper>& KnownPapers() {
  static const std::vector<Paper> kPapers = {{"Letter", 215.9, 279.4},
                                             {"A4", 210.0, 297.0},
                                             {"Legal", 215.9, 355.6},
                                             {"A3", 297.0, 420.0},
                                             {"A2", 420.0, 594.0}};
  return kPapers;
}

Result<Paper> ParsePaper(const std::string& text) {
  for (const Paper& paper : KnownPapers()) {
    if (Lower(paper.name) == Lower(text)) return paper;
  }
  Paper paper{text, 0.0, 0.0};
  const std::size_t cross = Lower(text).find('x');
  if (cross != std::string::npos && ReadSide(std::string_view(text).substr(0, cross), &paper.width_mm) &&
      ReadSide(std::string_view(text).substr(cross + 1), &paper.height_mm)) {
    paper.name += " mm";
    return paper;
  }
  return UsageError("there is no paper " + text +
                    "; give A4, A3, A2, Letter, Legal or WIDTHxHEIGHT in mm, each 100 to 2000");
}

struct PrintedDocument::Canvas {
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;
  int pages = 0;

  void Set(const PrintedLine& line) const {
    cairo_set_source_rgb(cairo, line.grey, line.grey, line.grey);
    cairo_set_line_width(cairo, line.width_mm);
    cairo_set_dash(cairo, &line.dash_mm, line.dash_mm > 0.0 ? 1 : 0, 0.0);
  }
  void Set(const PrintedText& style) const {
    cairo_select_font_face(cairo, "@cairo:", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, style.size_mm / kCapitalShare);
    cairo_set_source_rgb(cairo, style.grey, style.grey, style.grey);
  }
};

PrintedDocument::PrintedDocument(std::string_view title) : canvas_(std::make_unique<Canvas>()) {
  // The size is each page's own; cairo asks for one beforehand.
  canvas_->surface = cairo_pdf_surface_create_for_stream(&Append, &canvas_->bytes, 72.0, 72.0);
  cairo_pdf_surface_set_metadata(canvas_->surface, CAIRO_PDF_METADATA_TITLE, AsciiOnly(title).c_str());
  cairo_pdf_surface_set_metadata(canvas_->surface, CAIRO_PDF_METADATA_CREATE_DATE, "");  // leaves it out
  canvas_->cairo = cairo_create(canvas_->surface);
}

PrintedDocument::~PrintedDocument() {
  cairo_destroy(canvas_->cairo);
  cairo_surface_destroy(canvas_->surface);
}

int PrintedDocument::pages() const { return canvas_->pages; }

void PrintedDocument::BeginPage(double width_mm, double height_mm) {
  if (canvas_->pages++ > 0) cairo_show_page(canvas_->cairo);
  cairo_pdf_surface_set_size(canvas_->surface, width_mm * kPointsPerMm, height_mm * kPointsPerMm);
  cairo_identity_matrix(canvas_->cairo);
  cairo_reset_clip(canvas_->cairo);
  cairo_scale(canvas_->cairo, kPointsPerMm, -kPointsPerMm);
  cairo_translate(canvas_->cairo, 0.0, -height_mm);
}

void PrintedDocument::BeginFrame(const Eigen::Vector2d& origin, const Eigen::AlignedBox2d& clip) {
  cairo_save(canvas_->cairo);
  cairo_translate(canvas_->cairo, origin.x(), origin.y());
  cairo_rectangle(canvas_->cairo, clip.min().x(), clip.min().y(), clip.sizes().x(), clip.sizes().y());
  cairo_clip(canvas_->cairo);
}

void PrintedDocument::EndFrame() { cairo_restore(canvas_->cairo); }

void PrintedDocument::Line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const PrintedLine& line) {
  canvas_->Set(line);
  cairo_move_to(canvas_->cairo, a.x(), a.y());
  cairo_line_to(canvas_->cairo, b.x(), b.y());
  cairo_stroke(canvas_->cairo);
}

void PrintedDocument::Polygon(const std::vector<Eigen::Vector2d>& points, const PrintedLine& line) {
  canvas_->Set(line);
  cairo_new_path(canvas_->cairo);  // words leave their end as a current point
  for (const Eigen::Vector2d& p : points) cairo_line_to(canvas_->cairo, p.x(), p.y());
  cairo_close_path(canvas_->cairo);
  cairo_stroke(canvas_->cairo);
}

void PrintedDocument::FillBox(const Eigen::AlignedBox2d& box, double grey) {
  cairo_set_source_rgb(canvas_->cairo, grey, grey, grey);
  cairo_rectangle(canvas_->cairo, box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y());
  cairo_fill(canvas_->cairo);
}

double PrintedDocument::TextWidth(std::string_view text, const PrintedText& style) {
  cairo_save(canvas_->cairo);
  canvas_->Set(style);
  cairo_text_extents_t extents;
  cairo_text_extents(canvas_->cairo, AsciiOnly(text).c_str(), &extents);
  cairo_restore(canvas_->cairo);
  return extents.x_advance;
}

void PrintedDocument::Text(std::string_view text, const Eigen::Vector2d& at, const PrintedText& style) {
  const double width = TextWidth(text, style);
  const double back =
      style.align == PrintAlign::kLeft ? 0.0 : (style.align == PrintAlign::kCentre ? 0.5 : 1.0);
  cairo_save(canvas_->cairo);
  canvas_->Set(style);
  cairo_translate(canvas_->cairo, at.x(), at.y());
  if (style.upwards) cairo_rotate(canvas_->cairo, 1.5707963267948966);
  cairo_scale(canvas_->cairo, 1.0, -1.0);
  cairo_move_to(canvas_->cairo, -back * width, 0.0);
  cairo_show_text(canvas_->cairo, AsciiOnly(text).c_str());
  cairo_restore(canvas_->cairo);
}

std::vector<std::string> PrintedDocument::Wrap(const std::string& text, double width_mm,
                                               const PrintedText& style) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (lines.empty() || TextWidth(longer, style) > width_mm) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

Result<std::string> PrintedDocument::Finish() {
  cairo_show_page(canvas_->cairo);
  cairo_surface_finish(canvas_->surface);
  for (const cairo_status_t status : {cairo_status(canvas_->cairo), cairo_surface_status(canvas_->surface)}) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED) {
      throw std::logic_error(std::string("PrintedDocument: ") + cairo_status_to_string(status));
    }
  }
  return std::move(canvas_->bytes);
}

}  // namespace dorsum
