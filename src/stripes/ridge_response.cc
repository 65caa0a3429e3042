// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_response.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stripes/ridge_response.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// `rows`: the middle one, then pairs outwards, above and below.
void SmoothRows(const std::vector<std::int16_t>& kernel, const std::vector<const std::uint8_t*>& rows,
                std::size_t count, std::int16_t* out) {
  const hn::ScalableTag<std::int16_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  const std::size_t lanes = hn::Lanes(d);
  const auto get = [&](std::size_t k, std::size_t u) { return hn::PromoteTo(d, hn::LoadU(d8, rows[k] + u)); };
  std::size_t u = 0;
  for (; u + lanes <= count; u += lanes) {
    auto sum = hn::Mul(hn::Set(d, kernel[0]), get(0, u));
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      const auto pair = hn::Add(get(2 * k - 1, u), get(2 * k, u));
      sum = hn::Add(sum, hn::Mul(hn::Set(d, kernel[k]), pair));
    }
    hn::StoreU(sum, d, out + u);
  }
  for (; u < count; ++u) {
    int sum = kernel[0] * rows[0][u];
    for (std::size_t k = 1; k < kernel.size(); ++k) sum += kernel[k] * (rows[2 * k - 1][u] + rows[2 * k][u]);
    out[u] = static_cast<std::int16_t>(sum);
  }
}

// Whole vectors only: reads and writes up to one vector more than `count`.
void Filter(const std::vector<std::int16_t>& kernel, const std::int16_t* in, std::size_t count,
            std::int16_t* out) {
  const hn::ScalableTag<std::int16_t> d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t u = 0; u < count; u += lanes) {
    auto sum = hn::MulFixedPoint15(hn::Set(d, kernel[0]), hn::LoadU(d, in + u));
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      const auto pair = hn::Add(hn::LoadU(d, in + u - k), hn::LoadU(d, in + u + k));
      sum = hn::SaturatedAdd(sum, hn::MulFixedPoint15(hn::Set(d, kernel[k]), pair));
    }
    hn::StoreU(sum, d, out + u);
  }
}

void FindPeaks(const std::int16_t* r, std::size_t count, std::int16_t least, std::vector<int>* peaks) {
  const hn::ScalableTag<std::int16_t> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto below = hn::Set(d, static_cast<std::int16_t>(least - 1));
  std::size_t u = 1;
  for (; u + lanes + 1 <= count; u += lanes) {
    const auto here = hn::LoadU(d, r + u);
    const auto is_peak = hn::AndNot(hn::Gt(hn::LoadU(d, r + u + 1), here),
                                    hn::Gt(here, hn::Max(below, hn::LoadU(d, r + u - 1))));
    if (hn::AllFalse(d, is_peak)) continue;
    std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(d, is_peak, bytes.data());
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      for (unsigned bits = bytes[k]; bits != 0; bits &= bits - 1)
        peaks->push_back(static_cast<int>(u + 8 * k) + std::countr_zero(bits));
    }
  }
  for (; u + 1 < count; ++u) {
    if (r[u] >= least && r[u] > r[u - 1] && r[u] >= r[u + 1]) peaks->push_back(static_cast<int>(u));
  }
}

std::size_t Lanes16() { return hn::Lanes(hn::ScalableTag<std::int16_t>()); }

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(SmoothRows);
HWY_EXPORT(Filter);
HWY_EXPORT(FindPeaks);
HWY_EXPORT(Lanes16);

RidgeResponse::RidgeResponse(RidgeKernel kernel)
    : kernel_(std::move(kernel)), pad_(kernel_.columns.size() - 1), rows_(2 * kernel_.rows.size() - 1) {}

void RidgeResponse::Compute(const cv::Mat& green, int row, int first, int end) {
  const auto cols = static_cast<std::size_t>(end - first), beyond = HWY_DYNAMIC_DISPATCH(Lanes16)();
  padded_.resize(cols + 2 * pad_ + beyond);
  response_.resize(cols + beyond);
  // The part of the padded row that lies in the picture.
  const int pad = static_cast<int>(pad_), from = std::max(0, first - pad),
            to = std::min(green.cols, end + pad);
  const auto at = [&](int v) { return green.ptr<std::uint8_t>(std::clamp(v, 0, green.rows - 1)) + from; };
  rows_[0] = at(row);
  for (int k = 1; k < static_cast<int>(kernel_.rows.size()); ++k) {
    rows_[static_cast<std::size_t>(2 * k - 1)] = at(row - k);
    rows_[static_cast<std::size_t>(2 * k)] = at(row + k);
  }
  std::int16_t* inner = padded_.data() + (from - first + pad);
  std::int16_t* behind = inner + (to - from);
  HWY_DYNAMIC_DISPATCH(SmoothRows)(kernel_.rows, rows_, static_cast<std::size_t>(to - from), inner);
  std::fill(padded_.data(), inner, *inner);
  std::fill(behind, padded_.data() + padded_.size(), *(behind - 1));
  HWY_DYNAMIC_DISPATCH(Filter)(kernel_.columns, padded_.data() + pad_, cols, response_.data());
  response_.resize(cols);
}

const std::vector<int>& RidgeResponse::Peaks(std::int16_t least) {
  peaks_.clear();
  HWY_DYNAMIC_DISPATCH(FindPeaks)(response_.data(), response_.size(), least, &peaks_);
  return peaks_;
}

}  // namespace dorsum
#endif
