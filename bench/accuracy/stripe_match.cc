// SPDX-License-Identifier: Apache-2.0
#include "accuracy/stripe_match.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace dorsum::accuracy {
namespace {

constexpr double kLitIrradiance = 0.02, kFoundPx = 1.5, kFoundMm = 2.0, kStrayPx = 3.0;

int RowOf(const SurfacePoint& p) { return static_cast<int>(std::nearbyint(p.v)); }

// The stripes of one row out of a list sorted by row.
std::span<const TrueStripe> OfRow(const std::vector<TrueStripe>& stripes, int row) {
  const auto first = std::lower_bound(stripes.begin(), stripes.end(), row,
                                      [](const TrueStripe& s, int r) { return s.row < r; });
  auto last = first;
  while (last != stripes.end() && last->row == row) ++last;
  return {first, last};
}

const TrueStripe* Nearest(std::span<const TrueStripe> stripes, double u) {
  const auto nearest = std::min_element(
      stripes.begin(), stripes.end(),
      [&](const TrueStripe& a, const TrueStripe& b) { return std::abs(a.u - u) < std::abs(b.u - u); });
  return nearest == stripes.end() ? nullptr : &*nearest;
}

}  // namespace

StripeMatch MatchStripes(const CaptureTruth& truth, const SurfacePoints& points) {
  StripeMatch match;
  match.stray.assign(points.size(), 0);
  std::map<int, std::map<int, std::vector<std::size_t>>> by_laser_and_row;
  for (std::size_t i = 0; i < points.size(); ++i) {
    by_laser_and_row[points[i].laser][RowOf(points[i])].push_back(i);
  }
  for (const auto& [laser, stripes] : truth.lasers) {
    const auto& rows = by_laser_and_row[laser];
    for (const TrueStripe& s : stripes) {
      if (!(s.irradiance > kLitIrradiance) || !CaptureTruth::IsObject(s.material)) continue;
      ++match.wanted;
      const auto row = rows.find(s.row);
      if (row == rows.end()) continue;
      const bool found = std::any_of(row->second.begin(), row->second.end(), [&](std::size_t i) {
        return std::abs(points[i].u - s.u) < kFoundPx && std::abs(points[i].position.z() - s.z) < kFoundMm;
      });
      match.found += found ? 1 : 0;
    }
    for (const auto& [row, indices] : rows) {
      const std::span<const TrueStripe> true_row = OfRow(stripes, row);
      for (const std::size_t i : indices) {
        const TrueStripe* nearest = Nearest(true_row, points[i].u);
        match.stray[i] = nearest == nullptr || std::abs(nearest->u - points[i].u) > kStrayPx ? 1 : 0;
      }
    }
  }
  return match;
}

const TrueStripe* NearestStripe(const CaptureTruth& truth, const SurfacePoint& point) {
  const auto laser = truth.lasers.find(point.laser);
  if (laser == truth.lasers.end()) return nullptr;
  return Nearest(OfRow(laser->second, RowOf(point)), point.u);
}

}  // namespace dorsum::accuracy
