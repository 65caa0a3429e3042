// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

// A surface that bends alike in all directions has 3/8, 1/8 and 3/8 of the squared curvature in xx^2, xy^2
// and yy^2.
constexpr std::array<float, 3> kComponents = {8.0F / 3.0F, 8.0F, 8.0F / 3.0F};

// z_xx^2, z_xy^2 and z_yy^2 at the nodes whose neighbours are known, mm^-2; weight 0 or 1.
void SquaredCurvature(const PlateLattice& l, double step_mm, cv::Mat3f* curvature, cv::Mat1f* weight) {
  *curvature = cv::Mat3f(l.z.size(), cv::Vec3f::all(0.0F));
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
      (*curvature)(r, c) = scale * cv::Vec3f(xx * xx, xy * xy, yy * yy);
      (*weight)(r, c) = 1.0F;
    }
  }
}

// The variances of the three, each drawn a little towards their mean, where the square of the whole curvature
// is xx^2 + 2 xy^2 + yy^2. All alike, they are the square of the whole curvature.
cv::Vec3f Variances(const cv::Vec3f& squares, double share_between) {
  const float whole = squares[0] + 2.0F * squares[1] + squares[2];
  const auto share = static_cast<float>(share_between);
  cv::Vec3f out;
  for (int i = 0; i < 3; ++i)
    out[i] = share * whole + (1.0F - share) * kComponents[static_cast<std::size_t>(i)] * squares[i];
  return out;
}

}  // namespace

cv::Mat3f LocalStiffness(const PlateLattice& coarse, const PlateLattice& fine,
                         const PlateStiffnessOptions& options) {
  const double step_mm = coarse.step_px * options.mm_per_px;
  cv::Mat3f curvature;
  cv::Mat1f weight;
  SquaredCurvature(coarse, step_mm, &curvature, &weight);
  const double sigma = options.window_mm / step_mm;
  cv::GaussianBlur(curvature, curvature, {}, sigma, sigma, cv::BORDER_CONSTANT);
  cv::GaussianBlur(weight, weight, {}, sigma, sigma, cv::BORDER_CONSTANT);
  const auto least = static_cast<float>(options.least_curvature * options.least_curvature);
  const auto area = static_cast<float>(options.correlation_area_mm2);
  constexpr float kEnough = 1e-3F;  // of the window's weight
  // The largest curvature that is known at all stands in where there is none: better soft than stiff.
  float highest = 0.0F;
  for (int r = 0; r < coarse.z.rows; ++r) {
    for (int c = 0; c < coarse.z.cols; ++c) {
      if (weight(r, c) <= kEnough) continue;
      curvature(r, c) = Variances(curvature(r, c) / weight(r, c), options.share_between);
      for (int i = 0; i < 3; ++i) highest = std::max(highest, curvature(r, c)[i]);
    }
  }
  for (int r = 0; r < coarse.z.rows; ++r) {
    for (int c = 0; c < coarse.z.cols; ++c) {
      const cv::Vec3f k2 = weight(r, c) > kEnough ? curvature(r, c) : cv::Vec3f::all(highest);
      for (int i = 0; i < 3; ++i) curvature(r, c)[i] = 1.0F / (area * (least + k2[i]));
    }
  }
  if (fine.z.size() == coarse.z.size()) return curvature;
  cv::Mat3f out(fine.z.size());
  const double ratio = fine.step_px / coarse.step_px;
  const auto nearest = [&](int i, int count) {
    return std::min(count - 1, static_cast<int>(std::lround(i * ratio)));
  };
  std::vector<int> columns;
  columns.reserve(static_cast<std::size_t>(out.cols));
  for (int c = 0; c < out.cols; ++c) columns.push_back(nearest(c, coarse.z.cols));
  for (int r = 0; r < out.rows; ++r) {
    const auto* in = curvature.ptr<cv::Vec3f>(nearest(r, coarse.z.rows));
    auto* to = out.ptr<cv::Vec3f>(r);
    for (std::size_t c = 0; c < columns.size(); ++c) to[c] = in[columns[c]];
  }
  return out;
}

}  // namespace dorsum
