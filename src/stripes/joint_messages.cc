// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_messages.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/parallel.h"
#include "stripes/message_sweep.h"
#include "stripes/sweep_order.h"

namespace dorsum {
namespace {

// The graph with its pieces in the order of the sweeps, and what was sent so far.
class Messages {
 public:
  Messages(const std::vector<JointPiece>& pieces, const JointGraph& graph)
      : order_(OrderSweeps(pieces, graph)) {
    table_.ends.resize(pieces.size());
    std::vector<std::size_t> place(pieces.size());
    std::size_t most = 1;
    for (const auto& costs : graph.unary) most = std::max(most, costs.size());
    table_.wide = (most + kMessageLanes - 1) / kMessageLanes * kMessageLanes;
    table_.unary.assign(pieces.size() * table_.wide, kNoCandidate);
    for (std::size_t k = 0; k < order_.pieces.size(); ++k) {
      place[order_.pieces[k]] = k;
      const std::vector<float>& costs = graph.unary[order_.pieces[k]];
      std::copy(costs.begin(), costs.end(), &table_.unary[k * table_.wide]);
      table_.candidates.push_back(costs.size());
    }
    // What a piece reads lies together: the messages to it, and its edges' costs.
    struct Edge {
      const JointEdge* edge;
      std::size_t a, b;                      // places of its pieces
      std::array<std::uint32_t, 2> to = {};  // where the messages to them begin
    };
    std::vector<Edge> edges;
    edges.reserve(graph.edges.size());
    std::vector<std::vector<std::uint32_t>> edges_of(pieces.size());
    std::size_t costs = 0;
    for (const JointEdge& e : graph.edges) {
      const std::size_t a = place[static_cast<std::size_t>(e.first)],
                        b = place[static_cast<std::size_t>(e.second)];
      if (table_.candidates[a] == 0 || table_.candidates[b] == 0) continue;
      for (const std::size_t i : {a, b}) edges_of[i].push_back(static_cast<std::uint32_t>(edges.size()));
      edges.push_back({&e, a, b});
      costs += table_.candidates[a] + table_.candidates[b];
    }
    table_.messages.reserve(2 * edges.size() * table_.wide);
    table_.costs.reserve(costs * table_.wide);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const std::uint32_t k : edges_of[i])
        edges[k].to[edges[k].a == i ? 0 : 1] = AddMessage(table_.candidates[i]);
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      table_.ends[i].reserve(edges_of[i].size());
      for (const std::uint32_t k : edges_of[i]) {
        const Edge& e = edges[k];
        const bool is_first = e.a == i;
        table_.ends[i].push_back(
            {static_cast<std::uint32_t>(is_first ? e.b : e.a), e.to[is_first ? 0 : 1], e.to[is_first ? 1 : 0],
             AddCosts(*e.edge, table_.candidates[e.a], table_.candidates[e.b], is_first)});
      }
    }
  }

  // All pieces, in their order or against it; the largest change of a message.
  float Sweep(bool ahead, const Context& context) {
    const std::size_t left = order_.left_end, right = order_.right_end;
    std::array<float, 3> change{};
    const auto last = [&] { change[2] = SweepMessages(ahead, right, table_.ends.size(), &table_); };
    if (!ahead) last();
    ParallelFor(context, 0, 2, [&](std::int64_t side) {
      change[static_cast<std::size_t>(side)] =
          SweepMessages(ahead, side == 0 ? 0 : left, side == 0 ? left : right, &table_);
    });
    if (ahead) last();
    return *std::max_element(change.begin(), change.end());
  }

  // For each piece the cheapest candidate, given those of its neighbours that come before it.
  std::vector<int> Choose() const {
    std::vector<int> chosen(table_.ends.size(), -1), by_piece(table_.ends.size(), -1);
    for (std::size_t i = 0; i < table_.ends.size(); ++i) {
      if (table_.candidates[i] == 0) continue;
      std::vector<float> cost(&table_.unary[i * table_.wide],
                              &table_.unary[i * table_.wide] + table_.candidates[i]);
      for (const MessageEnd& e : table_.ends[i]) {
        for (std::size_t a = 0; a < cost.size(); ++a) {
          cost[a] += e.other < i
                         ? table_.costs[e.cost + a * table_.wide + static_cast<std::size_t>(chosen[e.other])]
                         : table_.messages[e.in + a];
        }
      }
      chosen[i] = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
      by_piece[order_.pieces[i]] = chosen[i];
    }
    return by_piece;
  }

 private:
  std::uint32_t AddMessage(std::size_t candidates) {
    const std::size_t at = table_.messages.size();
    table_.messages.resize(at + table_.wide, kNoCandidate);
    std::fill_n(&table_.messages[at], candidates, 0.0F);
    return static_cast<std::uint32_t>(at);
  }

  // An edge's costs by the candidates of its first or its second piece, which have `n` and `m`.
  std::uint32_t AddCosts(const JointEdge& e, std::size_t n, std::size_t m, bool by_first) {
    const std::size_t at = table_.costs.size();
    table_.costs.resize(at + (by_first ? n : m) * table_.wide, kNoCandidate);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < m; ++j)
        table_.costs[at + (by_first ? i * table_.wide + j : j * table_.wide + i)] =
            e.heights[i * m + j] + e.orders[i * m + j];
    }
    return static_cast<std::uint32_t>(at);
  }

  SweepOrder order_;
  MessageTable table_;
};

}  // namespace

std::vector<int> PassMessages(const std::vector<JointPiece>& pieces, const JointGraph& graph,
                              const MessagePassingOptions& options, const Context& context) {
  Messages messages(pieces, graph);
  for (int sweep = 0; sweep < options.max_sweeps; ++sweep) {
    if (messages.Sweep(sweep % 2 == 0, context) < options.tolerance) break;
  }
  return messages.Choose();
}

}  // namespace dorsum
