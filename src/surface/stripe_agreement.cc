// SPDX-License-Identifier: Apache-2.0
#include "surface/stripe_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/parallel.h"

namespace dorsum {
namespace {

// A point of a stripe.
struct StripePlace {
  std::uint64_t stripe;
  float v;
  std::uint32_t point;

  friend bool operator<(const StripePlace& a, const StripePlace& b) {
    return std::tie(a.stripe, a.v, a.point) < std::tie(b.stripe, b.v, b.point);
  }
};

// Sorts places of which each stripe's come together, mostly, and in order.
void SortStripes(std::vector<StripePlace>* all) {
  std::vector<std::pair<std::size_t, std::size_t>> stretches;  // begins and ends
  for (std::size_t i = 0; i < all->size(); ++i) {
    if (i == 0 || (*all)[i].stripe != (*all)[i - 1].stripe || (*all)[i] < (*all)[i - 1])
      stretches.emplace_back(i, i);
    ++stretches.back().second;
  }
  std::sort(stretches.begin(), stretches.end(),
            [&](const auto& a, const auto& b) { return (*all)[a.first] < (*all)[b.first]; });
  std::vector<StripePlace> out;
  out.reserve(all->size());
  for (const auto& [begin, end] : stretches) {
    out.insert(out.end(), all->begin() + static_cast<std::ptrdiff_t>(begin),
               all->begin() + static_cast<std::ptrdiff_t>(end));
  }
  if (!std::is_sorted(out.begin(), out.end())) std::sort(out.begin(), out.end());
  *all = std::move(out);
}

// The run that each point belongs to; runs are numbered along the points sorted by laser, order, segment and
// row.
std::vector<int> CutIntoRuns(const SurfacePoints& points, int* count) {
  constexpr float kMaxGapPx = 6.0F;
  constexpr double kMaxJumpMm = 3.0;
  std::vector<StripePlace> by_stripe;
  by_stripe.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    const auto order = static_cast<std::uint64_t>(static_cast<std::int64_t>(p.order) + 0x800000);
    by_stripe.push_back({static_cast<std::uint64_t>(p.laser) << 56U | order << 32U |
                             (static_cast<std::uint32_t>(p.segment) + 0x80000000U),
                         p.v, static_cast<std::uint32_t>(i)});
  }
  SortStripes(&by_stripe);
  std::vector<int> runs(points.size(), 0);
  int run = -1;
  const SurfacePoint* last = nullptr;
  for (const auto& [stripe, v, i] : by_stripe) {
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

// A point of a row.
struct RowPlace {
  float u;
  std::uint32_t point;
};

// Adds what the points of one row, in any order, say of each other.
void CompareRow(std::span<RowPlace> row, const SurfacePoints& points, const std::vector<int>& runs,
                const Outline& outline, const StripeAgreementOptions& options, Neighbours* out) {
  std::sort(row.begin(), row.end(), [](const RowPlace& a, const RowPlace& b) {
    return std::tie(a.u, a.point) < std::tie(b.u, b.point);
  });
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const std::uint32_t a = row[i].point, b = row[i + 1].point;
    const double apart = (points[b].u - points[a].u) * options.mm_per_px;
    if (runs[a] == runs[b] || apart > options.max_distance_mm ||
        !ObjectBetween(points[a], points[b], outline))
      continue;
    const double step = std::abs(points[b].position.z() - points[a].position.z());
    Rows& rows = (*out)[std::minmax(runs[a], runs[b])];
    ++(step <= std::min(options.slack_mm + options.max_slope * apart, options.max_step_mm) ? rows.agree
                                                                                           : rows.contradict);
  }
}

Neighbours CompareNeighbours(const SurfacePoints& points, const std::vector<int>& runs,
                             const Outline& outline, const StripeAgreementOptions& options,
                             const Context& context) {
  const auto row_of = [](const SurfacePoint& p) {
    return static_cast<std::size_t>(std::max(0L, std::lround(p.v)));
  };
  std::size_t rows = 0;
  for (const SurfacePoint& p : points) rows = std::max(rows, row_of(p) + 1);
  // By row: those of row r end where those of the next begin.
  std::vector<std::size_t> ends(rows + 1, 0);
  for (const SurfacePoint& p : points) ++ends[row_of(p) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<RowPlace> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    places[ends[row_of(points[i])]++] = {points[i].u, static_cast<std::uint32_t>(i)};

  constexpr std::size_t kRowsTogether = 64;
  std::vector<Neighbours> parts((rows + kRowsTogether - 1) / kRowsTogether);
  ParallelFor(context, 0, static_cast<std::int64_t>(parts.size()), [&](std::int64_t n) {
    const auto part = static_cast<std::size_t>(n);
    for (std::size_t r = part * kRowsTogether; r < std::min(rows, (part + 1) * kRowsTogether); ++r) {
      const std::size_t begin = r == 0 ? 0 : ends[r - 1];
      CompareRow(std::span(places).subspan(begin, ends[r] - begin), points, runs, outline, options,
                 &parts[part]);
    }
  });
  Neighbours out;
  for (const Neighbours& part : parts) {
    for (const auto& [pair, counts] : part) {
      out[pair].agree += counts.agree;
      out[pair].contradict += counts.contradict;
    }
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
                                const StripeAgreementOptions& options, const Context& context) {
  int count = 0;
  const std::vector<int> runs = CutIntoRuns(points, &count);
  const Neighbours neighbours = CompareNeighbours(points, runs, outline, options, context);
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
