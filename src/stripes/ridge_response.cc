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

using RowPointers = std::array<const std::uint8_t*, 5>;

// (1 4 6 4 1) / 16 of five rows.
void SmoothRows(const RowPointers& rows, std::size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  const hn::Rebind<std::int32_t, decltype(d)> d32;
  const std::size_t lanes = hn::Lanes(d);
  const auto get = [&](std::size_t k, std::size_t u) {
    return hn::PromoteTo(d32, hn::LoadU(d8, rows[k] + u));
  };
  std::size_t u = 0;
  for (; u + lanes <= count; u += lanes) {
    const auto outer = get(0, u) + get(4, u), inner = get(1, u) + get(3, u), middle = get(2, u);
    const auto sum = outer + hn::ShiftLeft<2>(inner + middle) + hn::ShiftLeft<1>(middle);
    hn::StoreU(hn::ConvertTo(d, sum) * hn::Set(d, 0.0625F), d, out + u);
  }
  for (; u < count; ++u) {
    const int sum = rows[0][u] + rows[4][u] + 4 * (rows[1][u] + rows[3][u]) + 6 * rows[2][u];
    out[u] = 0.0625F * static_cast<float>(sum);
  }
}

// Sums in the same order whatever the number of lanes.
void Filter(const std::vector<float>& kernel, const float* in, std::size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t u = 0;
  for (; u + lanes <= count; u += lanes) {
    auto sum = hn::Set(d, kernel[0]) * hn::LoadU(d, in + u);
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      sum = sum + hn::Set(d, kernel[k]) * (hn::LoadU(d, in + u - k) + hn::LoadU(d, in + u + k));
    }
    hn::StoreU(sum, d, out + u);
  }
  for (; u < count; ++u) {
    float sum = kernel[0] * in[u];
    for (std::size_t k = 1; k < kernel.size(); ++k) sum += kernel[k] * (*(in + u - k) + in[u + k]);
    out[u] = sum;
  }
}

void FindPeaks(const float* r, std::size_t count, float least, std::vector<int>* peaks) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto limit = hn::Set(d, least);
  std::size_t u = 1;
  for (; u + lanes + 1 <= count; u += lanes) {
    const auto here = hn::LoadU(d, r + u);
    const auto is_peak = hn::And(hn::Ge(here, limit), hn::And(hn::Gt(here, hn::LoadU(d, r + u - 1)),
                                                              hn::Ge(here, hn::LoadU(d, r + u + 1))));
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

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(SmoothRows);
HWY_EXPORT(Filter);
HWY_EXPORT(FindPeaks);

RidgeResponse::RidgeResponse(std::vector<float> kernel)
    : kernel_(std::move(kernel)), pad_(kernel_.size() - 1) {}

void RidgeResponse::Compute(const cv::Mat& green, int row, int first, int end) {
  const auto cols = static_cast<std::size_t>(end - first);
  padded_.resize(cols + 2 * pad_);
  response_.resize(cols);
  // The part of the padded row that lies in the picture.
  const int pad = static_cast<int>(pad_), from = std::max(0, first - pad),
            to = std::min(green.cols, end + pad);
  std::array<const std::uint8_t*, 5> rows{};
  for (int k = 0; k < 5; ++k) {
    rows[static_cast<std::size_t>(k)] =
        green.ptr<std::uint8_t>(std::clamp(row + k - 2, 0, green.rows - 1)) + from;
  }
  float* inner = padded_.data() + (from - first + pad);
  float* behind = inner + (to - from);
  HWY_DYNAMIC_DISPATCH(SmoothRows)(rows, static_cast<std::size_t>(to - from), inner);
  std::fill(padded_.data(), inner, *inner);
  std::fill(behind, padded_.data() + padded_.size(), *(behind - 1));
  HWY_DYNAMIC_DISPATCH(Filter)(kernel_, padded_.data() + pad_, cols, response_.data());
}

const std::vector<int>& RidgeResponse::Peaks(float least) {
  peaks_.clear();
  HWY_DYNAMIC_DISPATCH(FindPeaks)(response_.data(), response_.size(), least, &peaks_);
  return peaks_;
}

double NoiseGain(const std::vector<float>& kernel) {
  constexpr double kRows = (2.0 * 1.0 + 2.0 * 16.0 + 36.0) / 256.0;
  auto gain = static_cast<double>(kernel[0] * kernel[0]);
  for (std::size_t k = 1; k < kernel.size(); ++k) gain += 2.0 * static_cast<double>(kernel[k] * kernel[k]);
  return gain * kRows;
}

}  // namespace dorsum
#endif
