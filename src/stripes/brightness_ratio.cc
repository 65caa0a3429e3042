// SPDX-License-Identifier: Apache-2.0
#include "stripes/brightness_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "base/parallel.h"
#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stripes/brightness_ratio.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef DORSUM_STRIPES_RATIO_COLUMNS
#define DORSUM_STRIPES_RATIO_COLUMNS
namespace dorsum {

constexpr std::size_t kColumns = 16;  // cells of a row that are summed up side by side

// Where a window's rows begin, and the way from one to the next.
struct RatioWindow {
  const float *weight, *level, *ratio, *window;
  std::size_t cells_step, window_step;
  int rows;
  float middle_level;
};

// Sums down the columns of a window: of the weights w, and of their products with the row y, the level l
// above the middle's, and the ratio r.
struct RatioSums {
  using Columns = std::array<float, kColumns>;
  Columns w, wy, wyy, wl, wyl, wll, wr, wyr, wlr;
};

}  // namespace dorsum
#endif

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void SumColumns(const RatioWindow& in, RatioSums* out) {
  const hn::CappedTag<float, kColumns> d;
  for (std::size_t k = 0; k < kColumns; k += hn::Lanes(d)) {
    auto w = hn::Zero(d), wy = w, wyy = w, wl = w, wyl = w, wll = w, wr = w, wyr = w, wlr = w;
    for (int row = 0; row < in.rows; ++row) {
      const std::size_t at = static_cast<std::size_t>(row) * in.cells_step + k;
      const int from_middle = row - in.rows / 2;
      const auto y = hn::Set(d, static_cast<float>(from_middle));
      const auto share = hn::LoadU(d, in.window + static_cast<std::size_t>(row) * in.window_step + k);
      const auto a = hn::LoadU(d, in.weight + at) * share, r = hn::LoadU(d, in.ratio + at);
      const auto l = hn::LoadU(d, in.level + at) - hn::Set(d, in.middle_level), ay = a * y, al = a * l;
      w = w + a;
      wy = wy + ay;
      wyy = wyy + ay * y;
      wl = wl + al;
      wyl = wyl + al * y;
      wll = wll + al * l;
      wr = wr + a * r;
      wyr = wyr + ay * r;
      wlr = wlr + al * r;
    }
    hn::StoreU(w, d, &out->w[k]);
    hn::StoreU(wy, d, &out->wy[k]);
    hn::StoreU(wyy, d, &out->wyy[k]);
    hn::StoreU(wl, d, &out->wl[k]);
    hn::StoreU(wyl, d, &out->wyl[k]);
    hn::StoreU(wll, d, &out->wll[k]);
    hn::StoreU(wr, d, &out->wr[k]);
    hn::StoreU(wyr, d, &out->wyr[k]);
    hn::StoreU(wlr, d, &out->wlr[k]);
  }
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(SumColumns);

namespace {

constexpr int kCellPx = 4;
constexpr int kLanes = static_cast<int>(kColumns);

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
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  RatioSums sums;
  for (int first = 0; first < window_.cols; first += kLanes) {
    const int column = cell_x + first;
    HWY_DYNAMIC_DISPATCH(SumColumns)
    ({weight_[cell_y] + column, level_[cell_y] + column, ratio_[cell_y] + column, window_[0] + first,
      weight_.step1(), window_.step1(), window_.rows, level},
     &sums);
    for (std::size_t k = 0; k < kColumns; ++k) {
      const double x = first + static_cast<int>(k) - reach_, w = sums.w[k], l = sums.wl[k], r = sums.wr[k];
      const double y = sums.wy[k];
      matrix(0, 0) += w;
      matrix(1, 0) += x * w;
      matrix(2, 0) += y;
      matrix(3, 0) += l;
      matrix(1, 1) += x * x * w;
      matrix(2, 1) += x * y;
      matrix(3, 1) += x * l;
      matrix(2, 2) += static_cast<double>(sums.wyy[k]);
      matrix(3, 2) += static_cast<double>(sums.wyl[k]);
      matrix(3, 3) += static_cast<double>(sums.wll[k]);
      right += Eigen::Vector4d(r, x * r, static_cast<double>(sums.wyr[k]), static_cast<double>(sums.wlr[k]));
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
#endif
