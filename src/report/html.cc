// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/files.h"
#include "captures/jpeg_image.h"
#include "captures/png_image.h"
#include "report/drawing.h"
#include "report/html_style.h"

namespace dorsum {
namespace {

std::string Element(const std::string& name, const std::string& text) {
  return "<" + name + ">" + EscapeHtml(text) + "</" + name + ">\n";
}

// The grade as a word with a sign: colour alone would not reach everyone, nor a black and white print.
std::string Badge(Grade grade) {
  const char* sign = grade == Grade::kGood ? "&#10003;" : grade == Grade::kDoubtful ? "&#9888;" : "&#10007;";
  const std::string name = GradeName(grade);
  return "<span class='badge " + name + "'>" + sign + " " + name + "</span>";
}

// Counts without decimals, others with four significant digits.
std::string FormatFigure(const Figure& figure) {
  char text[64];
  const bool is_count =
      figure.unit.empty() && std::abs(figure.value) < 1e9 && figure.value == std::round(figure.value);
  std::snprintf(text, sizeof text, is_count ? "%.0f" : "%.4g", figure.value);
  return std::isfinite(figure.value) ? text : "-";
}

std::string CellHtml(const HtmlCell& cell, bool is_number) {
  std::string html = is_number ? "<td class='n'>" : "<td>";
  html += EscapeHtml(cell.text);
  if (cell.bar) {
    const double percent = 100.0 * std::clamp(std::isfinite(*cell.bar) ? *cell.bar : 0.0, 0.0, 1.0);
    html += "<span class='bar'><span style='width:" + FormatNumber(percent, 1) + "%'></span></span>";
  }
  return html + "</td>";
}

}  // namespace

std::string EscapeHtml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\n':
      case '\t':
        out += ' ';
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

std::string ImageUri(const cv::Mat& picture, ImageKind kind) {
  if (picture.empty()) return {};
  if (kind == ImageKind::kPhoto)
    return "data:image/jpeg;base64," + EncodeBase64(EncodeJpeg(picture, 86, true));
  return "data:image/png;base64," + EncodeBase64(EncodePng(picture, 6));
}

HtmlPage::HtmlPage(const std::string& title, const std::string& subtitle) : title_(title) {
  body_ = "<header>\n" + Element("h1", title) + "<p class='subtitle'>" + EscapeHtml(subtitle) +
          "</p>\n</header>\n";
}

void HtmlPage::Section(const std::string& heading, const std::string& intro) {
  body_ += Element("h2", heading);
  if (!intro.empty()) body_ += "<p class='intro'>" + EscapeHtml(intro) + "</p>\n";
}

void HtmlPage::Paragraph(const std::string& text) { body_ += Element("p", text); }

void HtmlPage::Facts(const std::vector<HtmlFact>& facts) {
  if (facts.empty()) return;
  body_ += "<dl class='facts'>\n";
  for (const HtmlFact& fact : facts) {
    body_ += "<div><dt>" + EscapeHtml(fact.name) + "</dt><dd>" + EscapeHtml(fact.value);
    if (!fact.unit.empty()) body_ += " <small>" + EscapeHtml(fact.unit) + "</small>";
    body_ += "</dd></div>\n";
  }
  body_ += "</dl>\n";
}

void HtmlPage::Warnings(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return;
  body_ += "<aside class='warnings'><strong>&#9888; ";
  body_ += warnings.size() == 1 ? "One warning" : std::to_string(warnings.size()) + " warnings";
  body_ += "</strong>\n<ul>\n";
  for (const std::string& warning : warnings) body_ += Element("li", warning);
  body_ += "</ul></aside>\n";
}

void HtmlPage::Verdicts(const std::vector<PartReport>& parts) {
  if (parts.empty()) return;
  body_ += "<div class='cards'>\n";
  for (const PartReport& part : parts) {
    body_ += std::string("<section class='card ") + GradeName(part.grade) + "'><h3><span class='part'>" +
             EscapeHtml(part.part) + "</span> " + Badge(part.grade) + "</h3>\n" + Element("p", part.verdict);
    if (!part.figures.empty()) body_ += "<table>\n";
    for (const Figure& figure : part.figures) {
      body_ += "<tr><td>" + EscapeHtml(figure.name) + "</td><td class='n'>" + FormatFigure(figure) +
               "</td><td class='unit'>" + EscapeHtml(figure.unit) + "</td></tr>\n";
    }
    body_ += part.figures.empty() ? "</section>\n" : "</table></section>\n";
  }
  body_ += "</div>\n";
}

void HtmlPage::AddFigure(const HtmlFigure& figure) {
  const std::string number = std::to_string(++figures_);
  body_ += figure.wide ? "<figure class='wide'>" : "<figure>";
  if (!figure.picture.empty()) {
    // A hidden check box lets a click enlarge the figure without any script.
    body_ += "<label title='Click to enlarge or shrink'><input type='checkbox' aria-label='Enlarge figure " +
             number + "'><img alt='" + EscapeHtml(figure.title) + "' width='" +
             std::to_string(figure.picture.cols) + "' height='" + std::to_string(figure.picture.rows) +
             "' src='" + ImageUri(figure.picture, figure.kind) + "'></label>\n";
  }
  body_ += "<figcaption><strong>" + number + ". " + EscapeHtml(figure.title) + "</strong> " +
           EscapeHtml(figure.caption) + "</figcaption></figure>\n";
}

void HtmlPage::Figures(const std::vector<HtmlFigure>& figures, int columns) {
  if (figures.empty()) return;
  body_ += columns > 2 ? "<div class='figures three'>\n" : "<div class='figures'>\n";
  for (const HtmlFigure& figure : figures) {
    if (!figure.picture.empty() || !figure.caption.empty()) AddFigure(figure);
  }
  body_ += "</div>\n";
}

void HtmlPage::Table(const HtmlTable& table) {
  if (table.rows.empty()) return;
  body_ += "<div class='scroll'><table>\n";
  if (!table.caption.empty()) body_ += Element("caption", table.caption);
  if (!table.header.empty()) {
    body_ += "<thead><tr>";
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      body_ += (i >= table.first_number ? "<th class='n'>" : "<th>") + EscapeHtml(table.header[i]) + "</th>";
    }
    body_ += "</tr></thead>\n";
  }
  body_ += "<tbody>\n";
  for (const auto& row : table.rows) {
    body_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) body_ += CellHtml(row[i], i >= table.first_number);
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

std::string HtmlPage::Finish(const std::string& footer) const {
  return "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n"
         "<meta name='viewport' content='width=device-width, initial-scale=1'>\n"
         R"(<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">)"
         "\n" +
         Element("title", title_) + "<style>\n" + std::string(ReportStyle()) +
         "</style>\n</head>\n<body>\n<main>\n" + body_ + "</main>\n<footer>" + EscapeHtml(footer) +
         "</footer>\n</body>\n</html>\n";
}

}  // namespace dorsum
