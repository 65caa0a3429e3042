// SPDX-License-Identifier: Apache-2.0
#include "stripes/brightness_ratio.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr int kCellPx = 4;

}  // namespace

BrightnessRatio::BrightnessRatio(cv::Size size, const std::vector<RatioSample>& samples, double window_px,
                                 const Context& context)
    : reach_(static_cast<int>(std::lround(2.5 * window_px / kCellPx))) {
  const double sd = window_px / kCellPx;
  for (int dy = -reach_; dy <= reach_; ++dy) {
    for (int dx = -reach_; dx <= reach_; ++dx) {
      window_.push_back(static_cast<float>(std::exp(-0.5 * (dx * dx + dy * dy) / (sd * sd))));
    }
  }
  const cv::Size cells(size.width / kCellPx + 1, size.height / kCellPx + 1);
  for (cv::Mat1f* m : {&ratio_, &level_, &weight_}) *m = cv::Mat1f(cells, 0.0F);
  for (const RatioSample& s : samples) {
    const cv::Point at(static_cast<int>(s.u) / kCellPx, static_cast<int>(s.v) / kCellPx);
    ratio_(at) += s.ratio;
    level_(at) += s.level;
    weight_(at) += 1.0F;
  }
  const cv::Mat1f least_one = cv::max(weight_, 1.0F);
  ratio_ /= least_one;
  level_ /= least_one;
  with_samples_.resize(weight_.total());
  ParallelFor(context, 0, cells.height, [&](std::int64_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < cells.width; ++x) {
      if (weight_(y, x) > 0.0F)
        with_samples_[static_cast<std::size_t>(y * cells.width + x)] = Fit(x, y, level_(y, x));
    }
  });
}

// Drawn towards 0: speckle makes a row's peak err by a tenth or more, alike over some rows.
RatioSlope BrightnessRatio::Fit(int cell_x, int cell_y, float level) const {
  constexpr double kNoise = 0.04;                           // variance of a ratio, rows being alike
  constexpr double kSlope = 0.006 * kCellPx, kShare = 0.5;  // usual sizes of the two slopes
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
  Eigen::Vector4f right = Eigen::Vector4f::Zero();
  for (int y = std::max(0, cell_y - reach_); y <= std::min(weight_.rows - 1, cell_y + reach_); ++y) {
    const float* window = &window_[static_cast<std::size_t>((y - cell_y + reach_) * (2 * reach_ + 1))];
    for (int x = std::max(0, cell_x - reach_); x <= std::min(weight_.cols - 1, cell_x + reach_); ++x) {
      if (weight_(y, x) <= 0.0F) continue;
      const Eigen::Vector4f row(1.0F, static_cast<float>(x - cell_x), static_cast<float>(y - cell_y),
                                level_(y, x) - level);
      const Eigen::Vector4f weighted = weight_(y, x) * window[x - cell_x + reach_] * row;
      matrix += weighted * row.transpose();
      right += ratio_(y, x) * weighted;
    }
  }
  Eigen::Matrix4d known = matrix.cast<double>();
  known.diagonal() += kNoise * Eigen::Vector4d(1.0, 1.0 / (kSlope * kSlope), 1.0 / (kSlope * kSlope),
                                               1.0 / (kShare * kShare));
  const Eigen::Vector4d solved = known.ldlt().solve(right.cast<double>());
  return {solved[1] / kCellPx, std::max(-1.0, solved[3])};
}

RatioSlope BrightnessRatio::At(double u, double v, double level) const {
  if (weight_.empty()) return {};
  const int x = std::clamp(static_cast<int>(u) / kCellPx, 0, weight_.cols - 1);
  const int y = std::clamp(static_cast<int>(v) / kCellPx, 0, weight_.rows - 1);
  if (weight_(y, x) > 0.0F) return with_samples_[static_cast<std::size_t>(y * weight_.cols + x)];
  return Fit(x, y, static_cast<float>(level));
}

}  // namespace dorsum
