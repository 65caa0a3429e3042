// SPDX-License-Identifier: Apache-2.0
#include "surface/border_distance.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/border_distance.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// to[c] = min over k of (from[c + k] + k^2); `from` has `reach` values of reach^2 on each side, `to` room for
// whole vectors.
void SpreadAcross(const std::uint16_t* from, int reach, std::size_t columns, std::uint16_t* to) {
  const hn::ScalableTag<std::uint16_t> d;
  for (std::size_t c = 0; c < columns; c += hn::Lanes(d)) {
    auto least = hn::LoadU(d, from + c);
    for (int k = 1; k < reach; ++k) {
      const auto square = hn::Set(d, static_cast<std::uint16_t>(k * k));
      // Whatever is further away than k is no nearer than what was found.
      if (k % 4 == 1 && hn::AllTrue(d, hn::Eq(hn::Max(least, square), square))) break;
      const auto nearer = hn::Min(hn::LoadU(d, from + c + k), hn::LoadU(d, from + c - k));
      least = hn::Min(least, hn::Add(nearer, square));
    }
    hn::StoreU(least, d, to + c);
  }
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(SpreadAcross);

cv::Mat1w SquaredBorderDistance(const cv::Mat& region, int reach) {
  const auto most = static_cast<std::uint16_t>(reach);
  const auto columns = static_cast<std::size_t>(region.cols);
  cv::Mat1w out(region.size());
  // Along columns, first from above, then from below.
  std::vector<std::uint16_t> last(columns, most);
  const auto step = [&](int r, const auto* given) {
    const auto* set = region.ptr<std::uint8_t>(r);
    auto* to = out.ptr<std::uint16_t>(r);
    for (std::size_t c = 0; c < columns; ++c) {
      const auto next = static_cast<std::uint16_t>(set[c] != 0 ? last[c] + 1 : 0);
      last[c] = std::min(next, given == nullptr ? most : given[c]);
      to[c] = last[c];
    }
  };
  const std::uint16_t* none = nullptr;
  for (int r = 0; r < region.rows; ++r) step(r, none);
  std::fill(last.begin(), last.end(), most);
  for (int r = region.rows - 1; r >= 0; --r) step(r, out.ptr<std::uint16_t>(r));
  const std::size_t side = static_cast<std::size_t>(reach), slack = 64;  // longer than any vector
  std::vector<std::uint16_t> padded(columns + 2 * side + slack, static_cast<std::uint16_t>(most * most));
  std::vector<std::uint16_t> row(columns + slack);
  for (int r = 0; r < region.rows; ++r) {
    auto* to = out.ptr<std::uint16_t>(r);
    for (std::size_t c = 0; c < columns; ++c) padded[side + c] = static_cast<std::uint16_t>(to[c] * to[c]);
    HWY_DYNAMIC_DISPATCH(SpreadAcross)(&padded[side], reach, columns, row.data());
    std::copy(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(columns), to);
  }
  return out;
}

}  // namespace dorsum
#endif
