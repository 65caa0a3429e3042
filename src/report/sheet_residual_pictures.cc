// SPDX-License-Identifier: Apache-2.0
#include "report/sheet_residual_pictures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <opencv2/imgproc.hpp>

#include "report/drawing.h"

namespace dorsum {
namespace {

constexpr int kLeft = 84, kRight = 112, kTop = 34, kBottom = 66;  // px around the plot

constexpr double kMicro = 1000.0;  // shorter numbers beside the axis

using Place = std::function<double(const SheetResidual&)>;

Colour HeightColour(const SheetResidualScales& scales, double height) {
  // The yellow end is too pale on paper.
  return SequentialColour(0.85 * std::clamp(scales.height_mm.Share(height), 0.0, 1.0));
}

// Means of the misses in bins of the axis, by height.
using Bins = std::map<double, std::map<int, std::pair<double, int>>>;

void DrawMeans(cv::Mat& canvas, const PlotArea& area, const Bins& bins, double bin_width,
               const SheetResidualScales& scales) {
  constexpr int kFewest = 5;
  for (const auto& [height, means] : bins) {
    const Colour colour = HeightColour(scales, height);
    cv::Point2d last;
    int last_bin = -1000000;
    for (const auto& [bin, sum] : means) {
      if (sum.second < kFewest) continue;
      const cv::Point2d at =
          area.ToPixel(bin * bin_width, std::clamp(kMicro * sum.first / sum.second, area.y.low, area.y.high));
      if (bin == last_bin + 1) DrawLine(canvas, last, at, colour, 2);
      cv::circle(canvas, {static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))}, 3,
                 Pen(colour), cv::FILLED, cv::LINE_AA);
      last = at;
      last_bin = bin;
    }
  }
}

cv::Mat Draw(const std::vector<SheetResidual>& residuals, int laser, const SheetResidualScales& scales,
             const Range& x_range, const std::string& x_name, double bin_width, double spread,
             const Place& place, cv::Size size) {
  size = {std::max(size.width, 320), std::max(size.height, 220)};
  cv::Mat canvas(size, CV_8UC3, Pen(kPaper));
  const PlotArea area{{kLeft, kTop, size.width - kLeft - kRight, size.height - kTop - kBottom},
                      x_range,
                      {kMicro * scales.miss_mm.low, kMicro * scales.miss_mm.high}};
  DrawGrid(canvas, area);
  Bins bins;
  for (const SheetResidual& r : residuals) {
    if (r.laser != laser || !std::isfinite(r.miss_mm)) continue;
    const double x = place(r);
    auto& bin = bins[r.height_mm][static_cast<int>(std::lround(x / bin_width))];
    if (std::abs(r.miss_mm) < 2.0 * scales.miss_mm.high) {
      bin.first += r.miss_mm;
      ++bin.second;
    }
    // Heights side by side within an order, so that they do not cover each other.
    const double aside = spread * (scales.height_mm.Share(r.height_mm) - 0.5);
    const cv::Point2d at = area.ToPixel(x + aside, kMicro * r.miss_mm);
    const cv::Point pixel(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)));
    if (!area.pixels.contains(pixel)) continue;
    const Colour faint = Mix(HeightColour(scales, r.height_mm), kPaper, 0.55);
    cv::rectangle(canvas, {pixel.x, pixel.y, 2, 2}, Pen(faint), cv::FILLED);
  }
  DrawMeans(canvas, area, bins, bin_width, scales);
  DrawAxes(canvas, area, x_name, "off the sheet (um)");
  DrawColourScale(canvas, {area.pixels.br().x + 26, area.pixels.y, 20, area.pixels.height}, scales.height_mm,
                  "height (mm)", [](double share) { return SequentialColour(0.85 * share); });
  return canvas;
}

}  // namespace

SheetResidualScales ScalesOf(const std::vector<SheetResidual>& residuals) {
  SheetResidualScales scales{{-0.05, 0.05}, {-100.0, 100.0}, {0.0, 50.0}, {-10.0, 10.0}};
  if (residuals.empty()) return scales;
  std::vector<double> misses;
  Range y{1e9, -1e9}, height{0.0, 1.0}, order{0.0, 0.0};
  for (const SheetResidual& r : residuals) {
    misses.push_back(std::abs(r.miss_mm));
    y = {std::min(y.low, r.y_mm), std::max(y.high, r.y_mm)};
    height.high = std::max(height.high, r.height_mm);
    order = {std::min<double>(order.low, r.order), std::max<double>(order.high, r.order)};
  }
  const auto high = misses.begin() + static_cast<std::ptrdiff_t>((misses.size() - 1) * 98 / 100);
  std::nth_element(misses.begin(), high, misses.end());
  const double reach = RoundOut({0.0, std::max(0.02, 1.2 * *high)}, 4).high;
  return {{-reach, reach}, RoundOut(y, 8), RoundOut(height, 5), {order.low - 0.8, order.high + 0.8}};
}

cv::Mat DrawSheetResidualsOverY(const std::vector<SheetResidual>& residuals, int laser,
                                const SheetResidualScales& scales,
                                const SheetResidualPictureOptions& options) {
  constexpr double kBin = 15.0;  // mm
  return Draw(
      residuals, laser, scales, scales.y_mm, "y (mm)", kBin, 0.0,
      [](const SheetResidual& r) { return r.y_mm; }, options.size);
}

cv::Mat DrawSheetResidualsOverOrder(const std::vector<SheetResidual>& residuals, int laser,
                                    const SheetResidualScales& scales,
                                    const SheetResidualPictureOptions& options) {
  return Draw(
      residuals, laser, scales, scales.order, "order", 1.0, 0.7,
      [](const SheetResidual& r) { return static_cast<double>(r.order); }, options.size);
}

}  // namespace dorsum
