// SPDX-License-Identifier: Apache-2.0
#include "stripes/profile_flanks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dorsum {
namespace {

constexpr int kReach = 12;  // columns to either side of the peak
constexpr std::size_t kColumns = 2 * kReach + 1;

// Sums of rows' grey values around their own columns, in whole units, so that what was added can be taken off
// again without a trace.
using Sums = std::array<std::int32_t, kColumns>;
constexpr int kUnit = 256;  // of a grey value

// Adds `sign` times the grey values of one row around u, between pixels.
void AddProfile(const std::uint8_t* row, int cols, double u, int sign, Sums* sum) {
  const double base = std::floor(u);
  const double rounded = kUnit * (u - base) + 0.5;
  const auto right = static_cast<std::uint16_t>(rounded);
  const auto left = static_cast<std::uint16_t>(kUnit - right);
  const int first = static_cast<int>(base) - kReach;
  std::array<std::uint8_t, kColumns + 1> clamped;
  const std::uint8_t* from = clamped.data();
  if (first >= 0 && first + static_cast<int>(kColumns) < cols) {
    from = row + first;
  } else {
    for (int i = 0; i <= static_cast<int>(kColumns); ++i) {
      clamped[static_cast<std::size_t>(i)] = row[std::clamp(first + i, 0, cols - 1)];
    }
  }
  std::array<std::uint16_t, kColumns> shifted;  // 256 times 255 at most
  for (std::size_t i = 0; i < kColumns; ++i)
    shifted[i] = static_cast<std::uint16_t>(left * from[i] + right * from[i + 1]);
  for (std::size_t i = 0; i < kColumns; ++i) (*sum)[i] += sign * shifted[i];
}

template <int kStep>
double FallToHalf(const Sums& sum, int peak) {
  const auto at = [&](int i) { return sum[static_cast<std::size_t>(peak + kStep * i)]; };
  const int reach = std::min(kReach, kStep < 0 ? peak : static_cast<int>(kColumns) - 1 - peak);
  // The background beside a stripe's foot, no further away than the next stripe's valley.
  std::int32_t low = at(0);
  for (int i = 1; i <= reach; ++i) low = std::min(low, at(i));
  const std::int32_t twice_half = at(0) + low;
  for (int i = 1; i <= reach; ++i) {
    if (2 * at(i) > twice_half) continue;
    const double before = at(i - 1), half = 0.5 * twice_half;
    return i - 1.0 + (before - half) / std::max(1e-9, before - at(i));
  }
  return kReach;
}

ProfileFlanks FlanksOf(const Sums& sum) {
  auto peak = static_cast<std::size_t>(kReach);
  for (std::size_t i = kReach - 2; i <= kReach + 2; ++i) peak = sum[i] > sum[peak] ? i : peak;
  const double before = sum[peak - 1], after = sum[peak + 1], curve = before - 2.0 * sum[peak] + after;
  const double shift = curve < 0.0 ? std::clamp(0.5 * (before - after) / curve, -0.5, 0.5) : 0.0;
  ProfileFlanks flanks;
  flanks.peak = static_cast<double>(peak) - kReach + shift;
  flanks.left = FallToHalf<-1>(sum, static_cast<int>(peak)) + shift;
  flanks.right = FallToHalf<1>(sum, static_cast<int>(peak)) - shift;
  return flanks;
}

}  // namespace

std::vector<ProfileFlanks> FlanksAlong(const cv::Mat& green, const std::vector<StripePoint>& points,
                                       int half_rows) {
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  std::vector<ProfileFlanks> flanks(points.size());
  Sums sum{};
  const auto add = [&](std::ptrdiff_t i, int sign) {
    const StripePoint& p = points[static_cast<std::size_t>(i)];
    AddProfile(green.ptr<std::uint8_t>(static_cast<int>(p.v)), green.cols, static_cast<double>(p.u), sign,
               &sum);
  };
  for (std::ptrdiff_t i = 0; i < std::min<std::ptrdiff_t>(half_rows, n); ++i) add(i, 1);
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (i + half_rows < n) add(i + half_rows, 1);
    if (i - half_rows - 1 >= 0) add(i - half_rows - 1, -1);
    flanks[static_cast<std::size_t>(i)] = FlanksOf(sum);
  }
  return flanks;
}

}  // namespace dorsum
