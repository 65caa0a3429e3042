// SPDX-License-Identifier: Apache-2.0
#include "report/correction_pictures.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "report/drawing.h"

namespace dorsum {
namespace {

constexpr int kLeft = 84, kRight = 112, kTop = 44, kBottom = 66;  // px around the plot
constexpr int kCellPx = 4;

bool IsFinite(const HeightSample& s) {
  return std::isfinite(s.x) && std::isfinite(s.z) && std::isfinite(s.h);
}

PlotArea Layout(const CorrectionScales& scales, cv::Size size) {
  return {
      {kLeft, kTop, std::max(40, size.width - kLeft - kRight), std::max(40, size.height - kTop - kBottom)},
      scales.x,
      scales.z};
}

cv::Mat MakeCanvas(const CorrectionPictureOptions& options) {
  return {std::max(options.size.height, 200), std::max(options.size.width, 300), CV_8UC3, Pen(kPaper)};
}

void Finish(cv::Mat& canvas, const PlotArea& area, const CorrectionScales& scales) {
  DrawAxes(canvas, area, "x (mm)", "z (mm)");
  DrawColourScale(canvas, {area.pixels.br().x + 26, area.pixels.y, 20, area.pixels.height},
                  {-scales.error_mm, scales.error_mm}, "error (mm)",
                  [](double share) { return DivergingColour(2.0 * share - 1.0); });
}

}  // namespace

CorrectionScales ScalesOf(const std::vector<HeightSample>& samples) {
  CorrectionScales scales{{-100.0, 100.0}, {0.0, 60.0}, 1.0};
  std::vector<double> x, z, error;
  for (const HeightSample& s : samples) {
    if (!IsFinite(s)) continue;
    x.push_back(s.x);
    z.push_back(s.z);
    error.push_back(std::abs(s.z - s.h));
  }
  if (x.empty()) return scales;
  std::sort(error.begin(), error.end());
  const auto [x_low, x_high] = std::minmax_element(x.begin(), x.end());
  const auto [z_low, z_high] = std::minmax_element(z.begin(), z.end());
  scales.x = RoundOut({*x_low, *x_high}, 10);
  scales.z = RoundOut({std::min(0.0, *z_low), 1.03 * *z_high}, 10);  // room for the highest box's dots
  scales.error_mm = RoundOut({0.0, std::max(0.05, error[(error.size() - 1) * 49 / 50])}, 4).high;
  return scales;
}

cv::Mat DrawCorrectionSamples(const std::vector<HeightSample>& samples, const CorrectionScales& scales,
                              const CorrectionPolynomial& polynomial,
                              const CorrectionPictureOptions& options) {
  cv::Mat canvas = MakeCanvas(options);
  const PlotArea area = Layout(scales, canvas.size());
  DrawGrid(canvas, area);
  // Samples that fall on one spot are averaged; else the last one drawn would hide the others.
  cv::Mat1d sum = cv::Mat1d::zeros(area.pixels.height / kCellPx + 1, area.pixels.width / kCellPx + 1);
  cv::Mat1i count = cv::Mat1i::zeros(sum.size());
  for (const HeightSample& s : samples) {
    if (!IsFinite(s)) continue;
    const cv::Point2d p = area.ToPixel(s.x, s.z) - cv::Point2d(area.pixels.tl());
    const bool is_outside = p.x < 0.0 || p.y < 0.0 || p.x > area.pixels.width || p.y > area.pixels.height;
    if (is_outside) continue;
    const cv::Point cell(static_cast<int>(p.x) / kCellPx, static_cast<int>(p.y) / kCellPx);
    sum(cell) += polynomial.CorrectedZ(s.x, s.z) - s.h;
    ++count(cell);
  }
  for (int row = 0; row < sum.rows; ++row) {
    for (int column = 0; column < sum.cols; ++column) {
      if (count(row, column) == 0) continue;
      const cv::Point at(area.pixels.x + column * kCellPx + kCellPx / 2,
                         area.pixels.y + row * kCellPx + kCellPx / 2);
      const Colour colour = DivergingColour(sum(row, column) / count(row, column) / scales.error_mm);
      cv::circle(canvas, at, 3, Pen(Mix(colour, {90, 90, 90}, 0.35)), cv::FILLED, cv::LINE_AA);
      cv::circle(canvas, at, 2, Pen(colour), cv::FILLED, cv::LINE_AA);
    }
  }
  Finish(canvas, area, scales);
  return canvas;
}

cv::Mat DrawCorrectionPolynomial(const CorrectionPolynomial& polynomial, const CorrectionScales& scales,
                                 const CorrectionPictureOptions& options) {
  cv::Mat canvas = MakeCanvas(options);
  const PlotArea area = Layout(scales, canvas.size());
  for (int row = area.pixels.y; row < area.pixels.br().y; ++row) {
    for (int column = area.pixels.x; column < area.pixels.br().x; ++column) {
      const double x = area.XAt(column), z = area.YAt(row);
      canvas.at<Colour>(row, column) = DivergingColour(z * polynomial.Evaluate(x, z) / scales.error_mm);
    }
  }
  Finish(canvas, area, scales);
  return canvas;
}

}  // namespace dorsum
