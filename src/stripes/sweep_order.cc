// SPDX-License-Identifier: Apache-2.0
#include "stripes/sweep_order.h"

#include <algorithm>
#include <numeric>

namespace dorsum {

SweepOrder OrderSweeps(const std::vector<JointPiece>& pieces, const JointGraph& graph) {
  std::vector<std::size_t> by_column(pieces.size());
  std::iota(by_column.begin(), by_column.end(), std::size_t{0});
  const auto column = [&](std::size_t i) {
    const auto& s = pieces[i].samples;
    return s.empty() ? 0.0F : s[s.size() / 2].u;
  };
  std::stable_sort(by_column.begin(), by_column.end(),
                   [&](std::size_t a, std::size_t b) { return column(a) < column(b); });
  const auto half = by_column.begin() + static_cast<std::ptrdiff_t>(by_column.size() / 2);
  std::vector<char> is_right(pieces.size(), 0), crosses(pieces.size(), 0);
  for (auto i = half; i != by_column.end(); ++i) is_right[*i] = 1;
  for (const JointEdge& e : graph.edges) {
    const auto a = static_cast<std::size_t>(e.first), b = static_cast<std::size_t>(e.second);
    if (is_right[a] != is_right[b]) crosses[a] = crosses[b] = 1;
  }
  SweepOrder order;
  order.pieces.reserve(pieces.size());
  const auto take = [&](auto from, auto to, char crossing) {
    std::copy_if(from, to, std::back_inserter(order.pieces),
                 [&](std::size_t i) { return crosses[i] == crossing; });
    return order.pieces.size();
  };
  order.left_end = take(by_column.begin(), half, 0);
  order.right_end = take(by_column.rbegin(), std::make_reverse_iterator(half), 0);
  take(by_column.begin(), by_column.end(), 1);
  return order;
}

}  // namespace dorsum
