// SPDX-License-Identifier: Apache-2.0
#include "report/plot.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "report/drawing.h"

namespace dorsum {
namespace {

constexpr double kNumberPx = 11.0, kNamePx = 12.5;

// 1, 2 or 5 times a power of ten.
double RoundStep(double span, int count) {
  const double raw = span / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * 0.999) return factor * power;
  }
  return 10.0 * power;
}

int Decimals(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 1;
  const double step = ticks[1] - ticks[0];
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

bool IsUsable(const Range& range) {
  return std::isfinite(range.low) && std::isfinite(range.high) && range.Span() > 0.0;
}

int TickCount(int pixels, int spacing_px) { return std::max(2, pixels / spacing_px); }

}  // namespace

std::vector<double> Ticks(const Range& range, int count) {
  std::vector<double> ticks;
  if (!IsUsable(range)) return ticks;
  const double step = RoundStep(range.Span(), count);
  // Counted as whole steps, since a running sum would drift off zero.
  const auto first = std::llround(std::ceil(range.low / step - 1e-9));
  const auto last = std::llround(std::floor(range.high / step + 1e-9));
  for (auto i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

Range RoundOut(const Range& range, int count) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high) || range.low > range.high) return {};
  const double span = std::max({range.Span(), 1e-6 * std::abs(range.high), 1e-6});
  const double step = RoundStep(span, count);
  Range out{std::floor(range.low / step + 1e-9) * step, std::ceil(range.high / step - 1e-9) * step};
  if (!(out.Span() > 0.0)) out.high = out.low + step;
  return out;
}

void DrawGrid(cv::Mat& canvas, const PlotArea& area) {
  for (const double x : Ticks(area.x, TickCount(area.pixels.width, 90))) {
    const double column = std::round(area.ToPixel(x, 0.0).x);
    DrawLine(canvas, {column, double(area.pixels.y)}, {column, double(area.pixels.br().y)}, kFaint);
  }
  for (const double y : Ticks(area.y, TickCount(area.pixels.height, 60))) {
    const double row = std::round(area.ToPixel(0.0, y).y);
    DrawLine(canvas, {double(area.pixels.x), row}, {double(area.pixels.br().x), row}, kFaint);
  }
}

void DrawAxes(cv::Mat& canvas, const PlotArea& area, const std::string& x_name, const std::string& y_name) {
  const cv::Rect& r = area.pixels;
  cv::rectangle(canvas, cv::Rect(r.x - 1, r.y - 1, r.width + 2, r.height + 2), Pen(kInk), 1);
  const std::vector<double> xs = Ticks(area.x, TickCount(r.width, 90));
  for (const double x : xs) {
    const double column = std::round(area.ToPixel(x, 0.0).x);
    DrawLine(canvas, {column, r.br().y + 1.0}, {column, r.br().y + 6.0}, kInk);
    DrawText(canvas, FormatNumber(x, Decimals(xs)), {column, r.br().y + 21.0},
             {.size_px = kNumberPx, .align = Align::kCentre});
  }
  const std::vector<double> ys = Ticks(area.y, TickCount(r.height, 60));
  for (const double y : ys) {
    const double row = std::round(area.ToPixel(0.0, y).y);
    DrawLine(canvas, {r.x - 2.0, row}, {r.x - 7.0, row}, kInk);
    DrawText(canvas, FormatNumber(y, Decimals(ys)), {r.x - 11.0, row + 0.5 * kNumberPx},
             {.size_px = kNumberPx, .align = Align::kRight});
  }
  DrawText(canvas, x_name, {r.x + 0.5 * r.width, r.br().y + 44.0},
           {.size_px = kNamePx, .align = Align::kCentre});
  DrawTextUpwards(canvas, y_name, {r.x - 50.0, r.y + 0.5 * r.height},
                  {.size_px = kNamePx, .align = Align::kCentre});
}

void DrawColourScale(cv::Mat& canvas, const cv::Rect& bar, const Range& values, const std::string& name,
                     const std::function<Colour(double share)>& colour) {
  for (int row = 0; row < bar.height; ++row) {
    canvas(cv::Rect(bar.x, bar.y + row, bar.width, 1)) = Pen(colour(1.0 - (row + 0.5) / bar.height));
  }
  cv::rectangle(canvas, cv::Rect(bar.x - 1, bar.y - 1, bar.width + 2, bar.height + 2), Pen(kInk), 1);
  const std::vector<double> ticks = Ticks(values, TickCount(bar.height, 55));
  for (const double value : ticks) {
    const double row = std::round(bar.y + (1.0 - values.Share(value)) * bar.height);
    DrawLine(canvas, {bar.br().x + 1.0, row}, {bar.br().x + 6.0, row}, kInk);
    DrawText(canvas, FormatNumber(value, Decimals(ticks)), {bar.br().x + 11.0, row + 0.5 * kNumberPx},
             {.size_px = kNumberPx});
  }
  DrawText(canvas, name, {canvas.cols - 10.0, bar.y - 14.0}, {.size_px = kNamePx, .align = Align::kRight});
}

}  // namespace dorsum
