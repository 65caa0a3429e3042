// SPDX-License-Identifier: Apache-2.0
#include "surface/stripe_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace dorsum {
namespace {

// The run that each point belongs to; runs are numbered along the points sorted by laser, order, segment and
// row.
std::vector<int> CutIntoRuns(const SurfacePoints& points, int* count) {
  constexpr float kMaxGapPx = 6.0F;
  constexpr double kMaxJumpMm = 3.0;
  std::vector<std::uint32_t> by_stripe(points.size());
  std::iota(by_stripe.begin(), by_stripe.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const SurfacePoint& p = points[i];
    return std::make_tuple(p.laser, p.order, p.segment, p.v, i);
  };
  std::sort(by_stripe.begin(), by_stripe.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<int> runs(points.size(), 0);
  int run = -1;
  const SurfacePoint* last = nullptr;
  for (const std::uint32_t i : by_stripe) {
    const SurfacePoint& p = points[i];
    const bool goes_on = last != nullptr && p.laser == last->laser && p.order == last->order &&
                         p.segment == last->segment && p.v - last->v <= kMaxGapPx &&
                         std::abs(p.position.z() - last->position.z()) <= kMaxJumpMm;
    if (!goes_on) ++run;
    runs[i] = run;
    last = &p;
  }
  *count = run + 1;
  return runs;
}

struct Rows {
  int agree = 0, contradict = 0;
};
using Neighbours = std::map<std::pair<int, int>, Rows>;

bool ObjectBetween(const SurfacePoint& a, const SurfacePoint& b, const Outline& outline) {
  const double du = b.u - a.u, dv = b.v - a.v;
  for (const double t : {0.25, 0.5, 0.75}) {
    if (outline.Distance(a.u + t * du, a.v + t * dv) <= 0.0F) return false;
  }
  return true;
}

Neighbours CompareNeighbours(const SurfacePoints& points, const std::vector<int>& runs,
                             const Outline& outline, const StripeAgreementOptions& options) {
  std::vector<std::pair<std::int64_t, std::uint32_t>> by_row;
  by_row.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    by_row.emplace_back(std::lround(points[i].v), static_cast<std::uint32_t>(i));
  std::sort(by_row.begin(), by_row.end(), [&](const auto& a, const auto& b) {
    return std::make_tuple(a.first, points[a.second].u, a.second) <
           std::make_tuple(b.first, points[b.second].u, b.second);
  });
  Neighbours out;
  for (std::size_t i = 0; i + 1 < by_row.size(); ++i) {
    if (by_row[i].first != by_row[i + 1].first) continue;
    const std::uint32_t a = by_row[i].second, b = by_row[i + 1].second;
    const double apart = (points[b].u - points[a].u) * options.mm_per_px;
    if (runs[a] == runs[b] || apart > options.max_distance_mm ||
        !ObjectBetween(points[a], points[b], outline))
      continue;
    const double step = std::abs(points[b].position.z() - points[a].position.z());
    Rows& rows = out[std::minmax(runs[a], runs[b])];
    ++(step <= std::min(options.slack_mm + options.max_slope * apart, options.max_step_mm) ? rows.agree
                                                                                           : rows.contradict);
  }
  return out;
}

int Root(std::vector<int>* parents, int i) {
  while ((*parents)[static_cast<std::size_t>(i)] != i) {
    int& parent = (*parents)[static_cast<std::size_t>(i)];
    parent = (*parents)[static_cast<std::size_t>(parent)];
    i = parent;
  }
  return i;
}

}  // namespace

std::vector<bool> FindMisplaced(const SurfacePoints& points, const Outline& outline,
                                const StripeAgreementOptions& options) {
  int count = 0;
  const std::vector<int> runs = CutIntoRuns(points, &count);
  const Neighbours neighbours = CompareNeighbours(points, runs, outline, options);
  std::vector<int> groups(static_cast<std::size_t>(count));
  std::iota(groups.begin(), groups.end(), 0);
  for (const auto& [pair, rows] : neighbours) {
    if (rows.agree <= rows.contradict) continue;
    const int a = Root(&groups, pair.first), b = Root(&groups, pair.second);
    groups[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  for (int i = 0; i < count; ++i) groups[static_cast<std::size_t>(i)] = Root(&groups, i);
  std::vector<int> sizes(groups.size(), 0), inside(groups.size(), 0), against(groups.size(), 0);
  const auto group_of = [&](int run) {
    return static_cast<std::size_t>(groups[static_cast<std::size_t>(run)]);
  };
  for (const int run : runs) ++sizes[group_of(run)];
  for (const auto& [pair, rows] : neighbours) {
    const std::size_t a = group_of(pair.first), b = group_of(pair.second);
    if (a == b) {
      inside[a] += rows.agree;
    } else {
      against[sizes[a] < sizes[b] ? a : b] += rows.contradict;
    }
  }
  std::vector<bool> out(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t g = group_of(runs[i]);
    out[i] = against[g] > 0 && against[g] >= inside[g];
  }
  return out;
}

}  // namespace dorsum
