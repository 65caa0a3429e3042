// SPDX-License-Identifier: Apache-2.0
#include "stripes/brightness_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr int kCellPx = 4;
constexpr int kLanes = 4;  // cells of a row that are summed up side by side

}  // namespace

BrightnessRatio::BrightnessRatio(cv::Size size, const std::vector<RatioSample>& samples, double window_px,
                                 const Context& context)
    : reach_(static_cast<int>(std::lround(2.5 * window_px / kCellPx))),
      window_(2 * reach_ + 1, (2 * reach_ + kLanes) / kLanes * kLanes, 0.0F) {
  const double sd = window_px / kCellPx;
  for (int dy = -reach_; dy <= reach_; ++dy) {
    for (int dx = -reach_; dx <= reach_; ++dx) {
      window_(dy + reach_, dx + reach_) =
          static_cast<float>(std::exp(-0.5 * (dx * dx + dy * dy) / (sd * sd)));
    }
  }
  cells_ = {size.width / kCellPx + 1, size.height / kCellPx + 1};
  // With a frame, so that a window never leaves them.
  const cv::Size framed(cells_.width + window_.cols, cells_.height + window_.rows);
  for (cv::Mat1f* m : {&ratio_, &level_, &weight_}) *m = cv::Mat1f(framed, 0.0F);
  for (const RatioSample& s : samples) {
    const cv::Point at(static_cast<int>(s.u) / kCellPx + reach_, static_cast<int>(s.v) / kCellPx + reach_);
    ratio_(at) += s.ratio;
    level_(at) += s.level;
    weight_(at) += 1.0F;
  }
  const cv::Mat1f least_one = cv::max(weight_, 1.0F);
  ratio_ /= least_one;
  level_ /= least_one;
  with_samples_.resize(static_cast<std::size_t>(cells_.area()));
  ParallelFor(context, 0, cells_.height, [&](std::int64_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < cells_.width; ++x) {
      const cv::Point at(x + reach_, y + reach_);
      if (weight_(at) > 0.0F)
        with_samples_[static_cast<std::size_t>(y * cells_.width + x)] = Fit(x, y, level_(at));
    }
  });
}

// Drawn towards 0: speckle makes a row's peak err by a tenth or more, alike over some rows.
RatioSlope BrightnessRatio::Fit(int cell_x, int cell_y, float level) const {
  constexpr double kNoise = 0.04;                           // variance of a ratio, rows being alike
  constexpr double kSlope = 0.006 * kCellPx, kShare = 0.5;  // usual sizes of the two slopes
  using Lanes = std::array<float, kLanes>;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (int first = 0; first < window_.cols; first += kLanes) {
    Lanes w{}, wy{}, wyy{}, wl{}, wyl{}, wll{}, wr{}, wyr{}, wlr{};  // sums of products down a column
    for (int row = 0; row < window_.rows; ++row) {
      const auto y = static_cast<float>(row - reach_);
      const float *weight = weight_[cell_y + row] + cell_x + first, *window = window_[row] + first;
      const float* levels = level_[cell_y + row] + cell_x + first;
      const float* ratios = ratio_[cell_y + row] + cell_x + first;
      for (std::size_t k = 0; k < kLanes; ++k) {
        const float a = weight[k] * window[k], l = levels[k] - level, ay = a * y, al = a * l, r = ratios[k];
        w[k] += a;
        wy[k] += ay;
        wyy[k] += ay * y;
        wl[k] += al;
        wyl[k] += al * y;
        wll[k] += al * l;
        wr[k] += a * r;
        wyr[k] += ay * r;
        wlr[k] += al * r;
      }
    }
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double x = first + static_cast<int>(k) - reach_, a = w[k], l = wl[k], r = wr[k], y = wy[k];
      matrix(0, 0) += a;
      matrix(1, 0) += x * a;
      matrix(2, 0) += y;
      matrix(3, 0) += l;
      matrix(1, 1) += x * x * a;
      matrix(2, 1) += x * y;
      matrix(3, 1) += x * l;
      matrix(2, 2) += static_cast<double>(wyy[k]);
      matrix(3, 2) += static_cast<double>(wyl[k]);
      matrix(3, 3) += static_cast<double>(wll[k]);
      right += Eigen::Vector4d(r, x * r, static_cast<double>(wyr[k]), static_cast<double>(wlr[k]));
    }
  }
  matrix.diagonal() += kNoise * Eigen::Vector4d(1.0, 1.0 / (kSlope * kSlope), 1.0 / (kSlope * kSlope),
                                                1.0 / (kShare * kShare));
  const Eigen::Vector4d solved = matrix.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  return {solved[1] / kCellPx, std::max(-1.0, solved[3])};
}

RatioSlope BrightnessRatio::At(double u, double v, double level) const {
  if (weight_.empty()) return {};
  const int x = std::clamp(static_cast<int>(u) / kCellPx, 0, cells_.width - 1);
  const int y = std::clamp(static_cast<int>(v) / kCellPx, 0, cells_.height - 1);
  if (weight_(y + reach_, x + reach_) > 0.0F)
    return with_samples_[static_cast<std::size_t>(y * cells_.width + x)];
  return Fit(x, y, static_cast<float>(level));
}

}  // namespace dorsum
