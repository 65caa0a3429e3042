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
  std::vector<std::int32_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    return stripes->segments[static_cast<std::size_t>(i)].min_u <
           stripes->segments[static_cast<std::size_t>(j)].min_u;
  });
  // From left to right, so that a parent's level is known before its children's.
  for (const std::int32_t i : order) {
    const auto [rows, parent] = strongest[static_cast<std::size_t>(i)];
    if (parent == kNoPoint) {
      tree.roots.push_back(i);
    } else {
      tree.nodes[static_cast<std::size_t>(i)].level = tree.nodes[static_cast<std::size_t>(parent)].level + 1;
    }
  }
  return tree;
}

}  // namespace dorsum
