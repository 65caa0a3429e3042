// SPDX-License-Identifier: Apache-2.0
#include "report/height_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "report/drawing.h"

namespace dorsum {
namespace {

constexpr int kLeft = 84, kRight = 120, kTop = 44, kBottom = 66;  // px around the map
constexpr double kMarginMm = 5.0;                                 // around what was seen
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Extent {
  Range x, y, z;
  bool any = false;
};

// Where the known heights lie. The colours leave out half a percent at each end, so that one stray point does
// not eat the scale.
Extent FindExtent(const HeightField& field) {
  Extent extent;
  int left = field.z.cols, right = -1, low = field.z.rows, high = -1;
  std::vector<float> heights;
  for (int r = 0; r < field.z.rows; ++r) {
    for (int c = 0; c < field.z.cols; ++c) {
      if (!std::isfinite(field.z(r, c))) continue;
      heights.push_back(field.z(r, c));
      left = std::min(left, c), right = std::max(right, c);
      low = std::min(low, r), high = std::max(high, r);
    }
  }
  if (heights.empty()) return {{-50.0, 50.0}, {-40.0, 40.0}, {0.0, 1.0}, false};
  std::sort(heights.begin(), heights.end());
  const std::size_t cut = heights.size() / 200;
  extent.x = {field.origin_mm.x() + left * field.pitch_mm - kMarginMm,
              field.origin_mm.x() + right * field.pitch_mm + kMarginMm};
  extent.y = {field.origin_mm.y() + low * field.pitch_mm - kMarginMm,
              field.origin_mm.y() + high * field.pitch_mm + kMarginMm};
  extent.z = RoundOut({heights[cut], heights[heights.size() - 1 - cut]});
  extent.any = true;
  return extent;
}

// The largest area of one scale in both directions in the place that the axes leave.
PlotArea Layout(const Extent& extent, cv::Size canvas) {
  const double wide = canvas.width - kLeft - kRight, high = canvas.height - kTop - kBottom;
  const double scale = std::min(wide / extent.x.Span(), high / extent.y.Span());
  const int w = std::max(8, static_cast<int>(scale * extent.x.Span()));
  const int h = std::max(8, static_cast<int>(scale * extent.y.Span()));
  return {{kLeft, kTop, w, h}, extent.x, extent.y};
}

// Between four known heights the bilinear one; at the border the nearest known one within half a cell.
float HeightAt(const HeightField& field, double x, double y) {
  const double c = (x - field.origin_mm.x()) / field.pitch_mm, r = (y - field.origin_mm.y()) / field.pitch_mm;
  const int c0 = static_cast<int>(std::floor(c)), r0 = static_cast<int>(std::floor(r));
  const auto at = [&](int row, int column) {
    const bool inside = row >= 0 && column >= 0 && row < field.z.rows && column < field.z.cols;
    return inside ? field.z(row, column) : kNan;
  };
  const double fc = c - c0, fr = r - r0;
  const double smooth = (1.0 - fr) * ((1.0 - fc) * at(r0, c0) + fc * at(r0, c0 + 1)) +
                        fr * ((1.0 - fc) * at(r0 + 1, c0) + fc * at(r0 + 1, c0 + 1));
  if (std::isfinite(smooth)) return static_cast<float>(smooth);
  return at(static_cast<int>(std::lround(r)), static_cast<int>(std::lround(c)));
}

cv::Mat1f SampleHeights(const HeightField& field, const PlotArea& area) {
  cv::Mat1f heights(area.pixels.size());
  for (int row = 0; row < heights.rows; ++row) {
    for (int column = 0; column < heights.cols; ++column) {
      heights(row, column) = HeightAt(field, area.XAt(area.pixels.x + column), area.YAt(area.pixels.y + row));
    }
  }
  return heights;
}

// Light from above left on the slope (dz/dx, dz/dy); 1 on level ground.
double Relief(double slope_x, double slope_y, double strength) {
  const double facing =
      (1.0 + 0.6 * slope_x - 0.6 * slope_y) / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
  return 1.0 + strength * (std::clamp(facing, 0.0, 1.6) - 1.0);
}

// How strongly a pixel belongs to a contour line, from its distance to the nearest one in pixels.
double ContourWeight(double height, double change_per_px, double interval) {
  if (interval <= 0.0 || change_per_px <= 1e-9) return 0.0;
  const double off = std::abs(height - interval * std::round(height / interval)) / change_per_px;
  return change_per_px > 0.25 * interval ? 0.0 : std::clamp(1.1 - off, 0.0, 1.0);
}

void PaintHeights(cv::Mat& canvas, const PlotArea& area, const cv::Mat1f& heights, const Range& scale,
                  const HeightPictureOptions& options) {
  const double mm_per_px = area.x.Span() / area.pixels.width;
  for (int row = 0; row < heights.rows; ++row) {
    for (int column = 0; column < heights.cols; ++column) {
      const double z = heights(row, column);
      if (!std::isfinite(z)) continue;
      const double right = column + 1 < heights.cols ? heights(row, column + 1) - z : 0.0;
      const double down = row + 1 < heights.rows ? heights(row + 1, column) - z : 0.0;
      Colour colour = SequentialColour(scale.Share(z));
      if (std::isfinite(right) && std::isfinite(down)) {
        const double light = Relief(right / mm_per_px, -down / mm_per_px, options.relief);
        colour =
            light < 1.0 ? Mix({0, 0, 0}, colour, light) : Mix(colour, kPaper, std::min(1.0, light - 1.0));
        colour =
            Mix(colour, {20, 16, 12}, 0.45 * ContourWeight(z, std::hypot(right, down), options.contour_mm));
      }
      canvas.at<Colour>(area.pixels.y + row, area.pixels.x + column) = colour;
    }
  }
}

}  // namespace

cv::Mat DrawHeightMap(const HeightField& field, const HeightPictureOptions& options) {
  const Extent extent = FindExtent(field);
  const PlotArea area = Layout(extent, {std::max(options.width_px, 320), std::max(options.height_px, 320)});
  cv::Mat canvas(kTop + area.pixels.height + kBottom, kLeft + area.pixels.width + kRight, CV_8UC3,
                 Pen(kPaper));
  DrawGrid(canvas, area);
  const Range scale = options.range_mm.value_or(extent.z);
  if (extent.any) {
    PaintHeights(canvas, area, SampleHeights(field, area), scale, options);
  } else {
    DrawText(canvas, "no heights",
             {area.pixels.x + 0.5 * area.pixels.width, area.pixels.y + 0.5 * area.pixels.height},
             {.size_px = 20.0, .align = Align::kCentre});
  }
  DrawAxes(canvas, area, "x (mm)", "y (mm)");
  const cv::Rect bar(area.pixels.br().x + 26, area.pixels.y, 20, area.pixels.height);
  DrawColourScale(canvas, bar, scale, "height (mm)", SequentialColour);
  return canvas;
}

}  // namespace dorsum
