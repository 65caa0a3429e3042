// SPDX-License-Identifier: Apache-2.0
#include "report/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCapitalUnits = 21.0;  // height of the font's capital letters at scale 1
constexpr int kSubPixelBits = 4;

std::string AsciiOnly(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) continue;  // one question mark for a whole UTF-8 character
    out += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  return out;
}

int Thickness(const TextStyle& style) {
  return std::max(1, static_cast<int>(std::lround(style.size_px * (style.bold ? 0.14 : 0.09))));
}

cv::Point SubPixel(cv::Point2d p) {
  constexpr double kScale = 1 << kSubPixelBits;
  const auto whole = [](double v) {
    return static_cast<int>(std::lround(std::clamp(v, -1e6, 1e6) * kScale));
  };
  return {whole(p.x), whole(p.y)};
}

}  // namespace

cv::Size MeasureText(const std::string& text, const TextStyle& style) {
  int baseline = 0;
  cv::Size size =
      cv::getTextSize(AsciiOnly(text), kFont, style.size_px / kCapitalUnits, Thickness(style), &baseline);
  size.height = static_cast<int>(std::lround(style.size_px));
  return size;
}

void DrawText(cv::Mat& canvas, const std::string& text, cv::Point2d at, const TextStyle& style) {
  const std::string ascii = AsciiOnly(text);
  const int width = MeasureText(ascii, style).width;
  const double shift = style.align == Align::kLeft     ? 0.0
                       : style.align == Align::kCentre ? 0.5 * width
                                                       : width;
  const cv::Point start(static_cast<int>(std::lround(at.x - shift)), static_cast<int>(std::lround(at.y)));
  const double scale = style.size_px / kCapitalUnits;
  cv::putText(canvas, ascii, start, kFont, scale, Pen(style.colour), Thickness(style), cv::LINE_AA);
}

void DrawTextUpwards(cv::Mat& canvas, const std::string& text, cv::Point2d at, const TextStyle& style) {
  // Turn the canvas instead of the letters: a copy of the whole is cheap beside what else is drawn.
  cv::Mat turned;
  cv::rotate(canvas, turned, cv::ROTATE_90_CLOCKWISE);
  DrawText(turned, text, {canvas.rows - 1.0 - at.y, at.x}, style);
  cv::rotate(turned, canvas, cv::ROTATE_90_COUNTERCLOCKWISE);
}

void DrawLine(cv::Mat& canvas, cv::Point2d a, cv::Point2d b, const Colour& colour, int thickness) {
  cv::line(canvas, SubPixel(a), SubPixel(b), Pen(colour), thickness, cv::LINE_AA, kSubPixelBits);
}

std::string FormatNumber(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  const std::string out = text;
  return out.find_first_not_of("-0.") == std::string::npos && out.front() == '-' ? out.substr(1) : out;
}

cv::Mat FitInto(const cv::Mat& picture, cv::Size size, const Colour& margin) {
  cv::Mat out(size, CV_8UC3, Pen(margin));
  if (picture.empty() || size.empty()) return out;
  const double scale = std::min(double(size.width) / picture.cols, double(size.height) / picture.rows);
  const cv::Size inner(std::clamp(static_cast<int>(std::lround(scale * picture.cols)), 1, size.width),
                       std::clamp(static_cast<int>(std::lround(scale * picture.rows)), 1, size.height));
  cv::Mat scaled;
  cv::resize(picture, scaled, inner, 0.0, 0.0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
  if (scaled.channels() == 1) cv::cvtColor(scaled, scaled, cv::COLOR_GRAY2BGR);
  scaled.copyTo(out(cv::Rect({(size.width - inner.width) / 2, (size.height - inner.height) / 2}, inner)));
  return out;
}

}  // namespace dorsum
