// SPDX-License-Identifier: Apache-2.0
#include "stripes/backplane_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/median.h"

namespace dorsum {
namespace {

// Distance along u from the nearest stripe of the empty backplane, px; positive to the right of it.
std::optional<double> ShiftOf(const StripePoint& p, const DeviceOrders& orders, int laser) {
  const auto u = static_cast<double>(p.u), v = static_cast<double>(p.v);
  const auto here = orders.At(laser, u, v), beside = orders.At(laser, u + 1.0, v);
  if (!here || !beside) return std::nullopt;
  const double order = here->OrderAt(0.0), next = beside->OrderAt(0.0);
  if (order == next) return std::nullopt;
  return (order - std::round(order)) / (next - order);
}

std::vector<double> Shifts(const LaserStripes& stripes, const DeviceOrders& orders, const cv::Mat& empty) {
  std::vector<double> shifts;
  const cv::Rect picture({}, empty.size());
  for (const StripePoint& p : stripes.points) {
    const cv::Point at(cvRound(p.u), cvRound(p.v));
    if (!picture.contains(at) || empty.at<std::uint8_t>(at) == 0) continue;
    if (const auto shift = ShiftOf(p, orders, stripes.laser)) shifts.push_back(*shift);
  }
  std::sort(shifts.begin(), shifts.end());
  return shifts;
}

// The most shifts that lie within twice `near_px`: their first and one past their last.
std::pair<std::size_t, std::size_t> Densest(const std::vector<double>& sorted, double near_px) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  for (std::size_t i = 0, j = 0; i < sorted.size(); ++i) {
    while (j < sorted.size() && sorted[j] <= sorted[i] + 2.0 * near_px) ++j;
    if (j - i > best.second - best.first) best = {i, j};
  }
  return best;
}

}  // namespace

std::vector<BackplaneCheck> CheckBackplane(const std::vector<LaserStripes>& stripes,
                                           const DeviceOrders& orders, const cv::Mat& empty,
                                           const BackplaneCheckOptions& options) {
  std::vector<BackplaneCheck> checks;
  for (const LaserStripes& one : stripes) {
    if (orders.device().FindLaser(one.laser) == nullptr) continue;
    BackplaneCheck& check = checks.emplace_back();
    check.laser = one.laser;
    const std::vector<double> shifts = Shifts(one, orders, empty);
    check.points = static_cast<int>(shifts.size());
    const auto [first, last] = Densest(shifts, options.near_px);
    const auto shared = static_cast<double>(last - first);
    if (check.points < options.min_points || shared < options.min_share * check.points) continue;
    std::vector<double> sizes;
    for (std::size_t i = first; i < last; ++i) sizes.push_back(std::abs(shifts[i]));
    check.shift_px = Median(std::move(sizes));
    check.moved = check.shift_px > options.max_shift_px;
  }
  return checks;
}

}  // namespace dorsum
