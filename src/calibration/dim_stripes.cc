// SPDX-License-Identifier: Apache-2.0
#include "calibration/dim_stripes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/median.h"

namespace dorsum {
namespace {

constexpr double kDimShare = 0.45;      // of the brightness that the stripes beside it let expect
constexpr double kWeakShare = 0.3;      // the same for a whole order
constexpr double kStretchShare = 0.06;  // of the image's height: shorter stretches are noise

struct Seen {
  double v = 0.0, peak = 0.0;
};
using Orders = std::map<int, std::vector<Seen>>;

// Brightness of a stripe near a row.
std::optional<double> PeakAt(const std::vector<Seen>& stripe, double v, double reach) {
  const auto it = std::lower_bound(stripe.begin(), stripe.end(), v - reach,
                                   [](const Seen& s, double row) { return s.v < row; });
  double sum = 0.0, count = 0.0;
  for (auto i = it; i != stripe.end() && i->v <= v + reach; ++i) {
    sum += i->peak;
    count += 1.0;
  }
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

// Each point's brightness over the mean of the stripes to both sides.
std::vector<double> Ratios(const Orders& orders, int m, double reach) {
  std::vector<double> ratios;
  const auto left = orders.find(m - 1), right = orders.find(m + 1);
  for (const Seen& s : orders.at(m)) {
    double sum = 0.0, count = 0.0;
    for (const auto& beside : {left, right}) {
      if (beside == orders.end()) continue;
      if (const auto peak = PeakAt(beside->second, s.v, reach)) {
        sum += *peak;
        count += 1.0;
      }
    }
    ratios.push_back(sum > 0.0 ? s.peak / (sum / count) : -1.0);
  }
  return ratios;
}

std::string Rows(int order, const char* what, double from, double to) {
  return "order " + std::to_string(order) + " is " + what + " on rows " + std::to_string(std::lround(from)) +
         " to " + std::to_string(std::lround(to));
}

}  // namespace

std::vector<std::string> FindDimStripes(const std::vector<SheetPoint>& points, int laser, int height_px) {
  Orders orders;
  for (const SheetPoint& p : points) {
    if (p.laser == laser && p.plane == 0) orders[p.order].push_back({p.v, p.peak});
  }
  std::vector<std::string> found;
  if (orders.size() < 3) return found;
  for (auto& [m, stripe] : orders) {
    std::sort(stripe.begin(), stripe.end(), [](const Seen& a, const Seen& b) { return a.v < b.v; });
  }
  const double reach = 0.03 * height_px, stretch = kStretchShare * height_px;
  const int first = orders.begin()->first, last = orders.rbegin()->first;
  for (int m = first + 1; m < last; ++m) {
    const auto it = orders.find(m);
    const auto count = [&orders](int order) {
      const auto at = orders.find(order);
      return at == orders.end() ? 0.0 : static_cast<double>(at->second.size());
    };
    if (it == orders.end() || count(m) < 0.4 * 0.5 * (count(m - 1) + count(m + 1))) {
      found.push_back("order " + std::to_string(m) + " is hardly seen on the backplane");
      continue;
    }
    const std::vector<Seen>& stripe = it->second;
    for (std::size_t i = 1; i < stripe.size(); ++i) {
      if (stripe[i].v - stripe[i - 1].v > 1.5 * stretch)
        found.push_back(Rows(m, "missing", stripe[i - 1].v, stripe[i].v));
    }
    const std::vector<double> ratios = Ratios(orders, m, reach);
    std::vector<double> known;
    for (const double r : ratios) {
      if (r > 0.0) known.push_back(r);
    }
    if (known.size() < 8) continue;
    const double usual = Median(known);
    if (usual < kWeakShare) found.push_back("order " + std::to_string(m) + " is dim against its neighbours");
    for (std::size_t i = 0; i < stripe.size();) {
      std::size_t end = i;
      while (end < stripe.size() && ratios[end] > 0.0 && ratios[end] < kDimShare * usual) ++end;
      if (end > i && stripe[end - 1].v - stripe[i].v > stretch)
        found.push_back(Rows(m, "dim", stripe[i].v, stripe[end - 1].v));
      i = std::max(end, i + 1);
    }
  }
  return found;
}

}  // namespace dorsum
