// SPDX-License-Identifier: Apache-2.0
#include "speed/steger.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

namespace dorsum::speed {
namespace {

struct Kernels {
  cv::Mat smooth, first, second;
};

// A Gaussian and its derivatives, sampled.
Kernels MakeKernels(double sd) {
  const int half = static_cast<int>(std::ceil(3.0 * sd));
  Kernels k;
  for (cv::Mat* m : {&k.smooth, &k.first, &k.second}) *m = cv::Mat(2 * half + 1, 1, CV_32F);
  for (int i = -half; i <= half; ++i) {
    const double x = i, g = std::exp(-0.5 * x * x / (sd * sd)) / (std::sqrt(2.0 * CV_PI) * sd);
    k.smooth.at<float>(i + half) = static_cast<float>(g);
    // sepFilter2D correlates, so the odd kernel is turned round.
    k.first.at<float>(i + half) = static_cast<float>(x / (sd * sd) * g);
    k.second.at<float>(i + half) = static_cast<float>((x * x / (sd * sd) - 1.0) / (sd * sd) * g);
  }
  return k;
}

}  // namespace

std::vector<cv::Point2f> DetectSteger(const cv::Mat& green, double width_px, double contrast) {
  const Kernels k = MakeKernels(width_px);
  cv::Mat1f x, y, xx, xy, yy;
  cv::sepFilter2D(green, x, CV_32F, k.first, k.smooth);
  cv::sepFilter2D(green, y, CV_32F, k.smooth, k.first);
  cv::sepFilter2D(green, xx, CV_32F, k.second, k.smooth);
  cv::sepFilter2D(green, xy, CV_32F, k.first, k.first);
  cv::sepFilter2D(green, yy, CV_32F, k.smooth, k.second);
  std::vector<std::vector<cv::Point2f>> rows(static_cast<std::size_t>(green.rows));
  cv::parallel_for_(cv::Range(0, green.rows), [&](const cv::Range& range) {
    for (int v = range.start; v < range.end; ++v) {
      for (int u = 0; u < green.cols; ++u) {
        // The eigenvector of the eigenvalue that is largest in magnitude.
        const double a = static_cast<double>(xx(v, u)), b = static_cast<double>(xy(v, u));
        const double c = static_cast<double>(yy(v, u));
        const double root = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
        const double low = 0.5 * (a + c) - root;
        if (low > -contrast) continue;
        double nx = b, ny = low - a;
        if (std::abs(nx) + std::abs(ny) < 1e-12) {
          nx = a < c ? 1.0 : 0.0;
          ny = 1.0 - nx;
        }
        const double length = std::hypot(nx, ny);
        nx /= length;
        ny /= length;
        const double t = -(static_cast<double>(x(v, u)) * nx + static_cast<double>(y(v, u)) * ny) / low;
        if (std::abs(t * nx) > 0.5 || std::abs(t * ny) > 0.5) continue;
        rows[static_cast<std::size_t>(v)].push_back(
            {static_cast<float>(u + t * nx), static_cast<float>(v + t * ny)});
      }
    }
  });
  std::vector<cv::Point2f> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace dorsum::speed
