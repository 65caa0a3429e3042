// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_stiffness.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// Squared curvature z_xx^2 + z_yy^2 + 2 z_xy^2 at the nodes whose neighbours are known, mm^-2; weight 0 or 1.
void SquaredCurvature(const PlateLattice& l, double step_mm, cv::Mat1f* curvature, cv::Mat1f* weight) {
  *curvature = cv::Mat1f(l.z.size(), 0.0F);
  *weight = cv::Mat1f(l.z.size(), 0.0F);
  const auto scale = static_cast<float>(1.0 / std::pow(step_mm, 4));
  for (int r = 1; r + 1 < l.z.rows; ++r) {
    const auto *a0 = l.active.ptr<std::uint8_t>(r - 1), *a1 = l.active.ptr<std::uint8_t>(r),
               *a2 = l.active.ptr<std::uint8_t>(r + 1);
    const auto *z0 = l.z.ptr<float>(r - 1), *z1 = l.z.ptr<float>(r), *z2 = l.z.ptr<float>(r + 1);
    for (int c = 1; c + 1 < l.z.cols; ++c) {
      if (a1[c] == 0 || a1[c - 1] == 0 || a1[c + 1] == 0 || a0[c] == 0 || a2[c] == 0 || a2[c + 1] == 0)
        continue;
      const float xx = z1[c - 1] - 2.0F * z1[c] + z1[c + 1], yy = z0[c] - 2.0F * z1[c] + z2[c];
      const float xy = z1[c] - z1[c + 1] - z2[c] + z2[c + 1];
      (*curvature)(r, c) = scale * (xx * xx + yy * yy + 2.0F * xy * xy);
      (*weight)(r, c) = 1.0F;
    }
  }
}

}  // namespace

cv::Mat1f LocalStiffness(const PlateLattice& coarse, const PlateLattice& fine,
                         const PlateStiffnessOptions& options) {
  const double step_mm = coarse.step_px * options.mm_per_px;
  cv::Mat1f curvature, weight;
  SquaredCurvature(coarse, step_mm, &curvature, &weight);
  const double sigma = options.window_mm / step_mm;
  cv::GaussianBlur(curvature, curvature, {}, sigma, sigma, cv::BORDER_CONSTANT);
  cv::GaussianBlur(weight, weight, {}, sigma, sigma, cv::BORDER_CONSTANT);
  const auto least = static_cast<float>(options.least_curvature * options.least_curvature);
  const auto area = static_cast<float>(options.correlation_area_mm2);
  constexpr float kEnough = 1e-3F;  // of the window's weight
  // The largest curvature that is known at all stands in where there is none: better soft than stiff.
  double highest = 0.0;
  for (int r = 0; r < coarse.z.rows; ++r) {
    for (int c = 0; c < coarse.z.cols; ++c) {
      if (weight(r, c) > kEnough) {
        curvature(r, c) /= weight(r, c);
        highest = std::max(highest, static_cast<double>(curvature(r, c)));
      }
    }
  }
  cv::Mat1f out(fine.z.size(), 1.0F);
  const double ratio = fine.step_px / coarse.step_px;
  for (int r = 0; r < out.rows; ++r) {
    const int y = std::min(coarse.z.rows - 1, static_cast<int>(std::lround(r * ratio)));
    for (int c = 0; c < out.cols; ++c) {
      const int x = std::min(coarse.z.cols - 1, static_cast<int>(std::lround(c * ratio)));
      const float k2 = weight(y, x) > kEnough ? curvature(y, x) : static_cast<float>(highest);
      out(r, c) = 1.0F / (area * (least + k2));
    }
  }
  return out;
}

}  // namespace dorsum
