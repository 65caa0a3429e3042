// SPDX-License-Identifier: Apache-2.0
#include "stripes/stripe_tree.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace dorsum {
namespace {

// Links neighbours within each row and counts, for every pair of segments, in how many rows they are.
std::map<std::pair<std::int32_t, std::int32_t>, int> LinkRows(LaserStripes* stripes) {
  std::vector<std::int32_t> by_row(stripes->points.size());
  std::iota(by_row.begin(), by_row.end(), 0);
  const auto& points = stripes->points;
  std::stable_sort(by_row.begin(), by_row.end(), [&](std::int32_t i, std::int32_t j) {
    const auto& p = points[static_cast<std::size_t>(i)];
    const auto& q = points[static_cast<std::size_t>(j)];
    return p.v != q.v ? p.v < q.v : p.u < q.u;
  });
  std::map<std::pair<std::int32_t, std::int32_t>, int> shared;
  for (std::size_t i = 1; i < by_row.size(); ++i) {
    StripePoint& left = stripes->points[static_cast<std::size_t>(by_row[i - 1])];
    StripePoint& right = stripes->points[static_cast<std::size_t>(by_row[i])];
    if (left.v != right.v || left.segment == right.segment) continue;
    left.right = by_row[i];
    right.left = by_row[i - 1];
    ++shared[{left.segment, right.segment}];
  }
  return shared;
}

// Steps from a segment over strongest parents to a root. A slanted stripe can reach further left than its
// parent, so the segments' columns would not tell whose level to find first. Crooked pieces can be each
// other's ancestors; no more steps than there are segments are counted then.
int CountAncestors(const std::vector<std::pair<int, std::int32_t>>& strongest, std::size_t segment) {
  int steps = 0;
  std::int32_t parent = strongest[segment].second;
  while (parent != kNoPoint && steps < static_cast<int>(strongest.size())) {
    ++steps;
    parent = strongest[static_cast<std::size_t>(parent)].second;
  }
  return steps;
}

}  // namespace

StripeTree BuildStripeTree(LaserStripes* stripes, int min_shared_rows) {
  StripeTree tree;
  const std::size_t n = stripes->segments.size();
  tree.nodes.resize(n);
  std::vector<std::pair<int, std::int32_t>> strongest(n, {0, kNoPoint});  // rows, parent
  const auto shared = LinkRows(stripes);
  for (const auto& [pair, rows] : shared) {
    const auto [left, right] = pair;
    // Two crooked pieces can stand left of each other in different rows; then the larger count decides.
    const auto back = shared.find({right, left});
    if (rows < min_shared_rows ||
        (back != shared.end() && (back->second > rows || (back->second == rows && right < left)))) {
      continue;
    }
    tree.nodes[static_cast<std::size_t>(left)].children.push_back(right);
    tree.nodes[static_cast<std::size_t>(right)].parents.push_back(left);
    auto& best = strongest[static_cast<std::size_t>(right)];
    if (rows > best.first) best = {rows, left};
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (strongest[i].second == kNoPoint) tree.roots.push_back(static_cast<std::int32_t>(i));
    tree.nodes[i].level = CountAncestors(strongest, i);
  }
  std::stable_sort(tree.roots.begin(), tree.roots.end(), [&](std::int32_t i, std::int32_t j) {
    return stripes->segments[static_cast<std::size_t>(i)].min_u <
           stripes->segments[static_cast<std::size_t>(j)].min_u;
  });
  return tree;
}

}  // namespace dorsum
