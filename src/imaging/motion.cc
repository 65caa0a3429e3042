// SPDX-License-Identifier: Apache-2.0
#include "imaging/motion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

cv::Mat SmoothGreen(const cv::Mat& bgr, double blur_px) {
  cv::Mat green, smooth;
  cv::extractChannel(bgr, green, 1);
  green.convertTo(green, CV_32F);
  cv::GaussianBlur(green, smooth, {}, blur_px);
  return smooth;
}

float Median(std::vector<float> list) {
  if (list.empty()) return 0.0F;
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
  std::nth_element(list.begin(), middle, list.end());
  return *middle;
}

// Every third pixel of every third row: the usual brightness.
double UsualValue(const cv::Mat& values) {
  std::vector<float> list;
  for (int v = 0; v < values.rows; v += 3) {
    const auto* row = values.ptr<float>(v);
    for (int u = 0; u < values.cols; u += 3) list.push_back(row[u]);
  }
  return static_cast<double>(Median(std::move(list)));
}

// Standard deviation of a pixel's noise in the difference of two pictures, from neighbours in a row: whatever
// moved changed both of them by about the same.
double NoiseOfDifference(const cv::Mat& before, const cv::Mat& after) {
  std::vector<float> list;
  for (int v = 0; v < before.rows; v += 3) {
    const auto *a = before.ptr<cv::Vec3b>(v), *b = after.ptr<cv::Vec3b>(v);
    for (int u = 0; u + 1 < before.cols; u += 3) {
      list.push_back(static_cast<float>(std::abs((b[u + 1][1] - a[u + 1][1]) - (b[u][1] - a[u][1]))));
    }
  }
  // Codes are whole numbers: no less than what rounding leaves.
  return std::max(0.3, static_cast<double>(Median(std::move(list))) / 0.6745) / std::numbers::sqrt2;
}

// Sums of one square: the structure tensor, and gradient times difference.
struct TileSums {
  double xx = 0.0, xy = 0.0, yy = 0.0, xd = 0.0, yd = 0.0;
};

struct TileShift {
  double shift = 0.0, sd = 0.0;
};

// Along the stronger direction of the square's gradients.
TileShift Solve(const TileSums& s, double difference_sd) {
  const double mean = 0.5 * (s.xx + s.yy), half = std::hypot(0.5 * (s.xx - s.yy), s.xy);
  const double strongest = mean + half;
  if (strongest <= 0.0) return {0.0, 1e9};
  const double angle = 0.5 * std::atan2(2.0 * s.xy, s.xx - s.yy);
  const double along = s.xd * std::cos(angle) + s.yd * std::sin(angle);
  return {std::abs(along) / strongest, difference_sd / std::sqrt(strongest)};
}

}  // namespace

PictureMotion MeasureMotion(const cv::Mat& before, const cv::Mat& after, const MotionOptions& options) {
  if (before.size() != after.size() || before.type() != CV_8UC3 || after.type() != CV_8UC3) {
    throw std::logic_error("MeasureMotion needs two CV_8UC3 pictures of one size");
  }
  cv::Mat a = SmoothGreen(before, options.blur_px), b = SmoothGreen(after, options.blur_px);
  b *= UsualValue(a) / std::max(1e-3, UsualValue(b));
  const cv::Mat difference = b - a, sum = 0.5 * (a + b);
  // A blur takes white noise down by 2 sqrt(pi) blur, and makes 4 pi blur^2 pixels err alike: in a square's
  // sums the two cancel.
  const double sd = NoiseOfDifference(before, after);
  cv::Mat gx, gy;
  cv::Sobel(sum, gx, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(sum, gy, CV_32F, 0, 1, 3, 0.125);

  PictureMotion motion;
  std::vector<double> sure;
  for (int top = 0; top + options.tile_px <= a.rows; top += options.tile_px) {
    for (int left = 0; left + options.tile_px <= a.cols; left += options.tile_px) {
      TileSums s;
      for (int v = top; v < top + options.tile_px; ++v) {
        const auto *x = gx.ptr<float>(v), *y = gy.ptr<float>(v), *d = difference.ptr<float>(v);
        for (int u = left; u < left + options.tile_px; ++u) {
          s.xx += static_cast<double>(x[u] * x[u]);
          s.xy += static_cast<double>(x[u] * y[u]);
          s.yy += static_cast<double>(y[u] * y[u]);
          s.xd += static_cast<double>(x[u] * d[u]);
          s.yd += static_cast<double>(y[u] * d[u]);
        }
      }
      const TileShift shift = Solve(s, sd);
      if (shift.sd > options.max_sd_px) continue;
      ++motion.tiles;
      sure.push_back(std::max(0.0, shift.shift - 3.0 * shift.sd));
    }
  }
  if (static_cast<int>(sure.size()) >= options.agreeing) {
    const auto nth = sure.begin() + options.agreeing - 1;
    std::nth_element(sure.begin(), nth, sure.end(), std::greater<>());
    motion.shift_px = *nth;
  }
  return motion;
}

}  // namespace dorsum
