// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dorsum {
namespace {

// One end of an edge, seen from its piece.
struct End {
  std::size_t other = 0;                     // the piece at the other end
  std::size_t in = 0, out = 0;               // where its messages to this piece and back begin
  std::size_t cost = 0;                      // where the edge's costs begin
  std::size_t own_step = 0, other_step = 0;  // from one candidate to the next in that table
};

// The graph in flat arrays, with its pieces in the order of the sweeps.
class Messages {
 public:
  Messages(const std::vector<JointPiece>& pieces, const JointGraph& graph) : ends_(pieces.size()) {
    std::vector<std::size_t> order(pieces.size()), place(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto column = [&](std::size_t i) {
      const auto& s = pieces[i].samples;
      return s.empty() ? 0.0F : s[s.size() / 2].u;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return column(a) < column(b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
      place[order[k]] = k;
      unary_.push_back(graph.unary[order[k]]);
    }
    for (const JointEdge& e : graph.edges) {
      const std::size_t a = place[static_cast<std::size_t>(e.first)],
                        b = place[static_cast<std::size_t>(e.second)];
      const std::size_t n = unary_[a].size(), m = unary_[b].size();
      if (n == 0 || m == 0) continue;
      const std::size_t to_a = messages_.size(), to_b = to_a + n, cost = costs_.size();
      messages_.resize(to_b + m, 0.0F);
      for (std::size_t k = 0; k < n * m; ++k) costs_.push_back(e.heights[k] + e.orders[k]);
      ends_[a].push_back({b, to_a, to_b, cost, m, 1});
      ends_[b].push_back({a, to_b, to_a, cost, 1, m});
    }
    order_ = std::move(order);
  }

  // Sends messages from all pieces to their neighbours on one side; the largest change.
  float Sweep(bool ahead) {
    float change = 0.0F;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      change = std::max(change, SendFrom(ahead ? k : ends_.size() - 1 - k, ahead));
    }
    return change;
  }

  // For each piece the cheapest candidate, given those of its neighbours that come before it.
  std::vector<int> Choose() const {
    std::vector<int> chosen(ends_.size(), -1), by_piece(ends_.size(), -1);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (unary_[i].empty()) continue;
      std::vector<float> cost = unary_[i];
      for (const End& e : ends_[i]) {
        for (std::size_t a = 0; a < cost.size(); ++a) {
          cost[a] +=
              e.other < i
                  ? costs_[e.cost + a * e.own_step + static_cast<std::size_t>(chosen[e.other]) * e.other_step]
                  : messages_[e.in + a];
        }
      }
      chosen[i] = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
      by_piece[order_[i]] = chosen[i];
    }
    return by_piece;
  }

 private:
  float SendFrom(std::size_t i, bool ahead) {
    belief_ = unary_[i];
    const std::size_t n = belief_.size();
    int before = 0, behind = 0;
    for (const End& e : ends_[i]) {
      for (std::size_t a = 0; a < n; ++a) belief_[a] += messages_[e.in + a];
      ++(e.other < i ? before : behind);
    }
    const float share = 1.0F / static_cast<float>(std::max({before, behind, 1}));
    for (float& b : belief_) b *= share;
    float change = 0.0F;
    for (const End& e : ends_[i]) {
      if ((e.other > i) != ahead) continue;
      const std::size_t m = unary_[e.other].size();
      fresh_.assign(m, std::numeric_limits<float>::max());
      for (std::size_t a = 0; a < n; ++a) {
        const float base = belief_[a] - messages_[e.in + a];
        const float* cost = &costs_[e.cost + a * e.own_step];
        for (std::size_t b = 0; b < m; ++b) fresh_[b] = std::min(fresh_[b], base + cost[b * e.other_step]);
      }
      const float least = *std::min_element(fresh_.begin(), fresh_.end());
      for (std::size_t b = 0; b < m; ++b) {
        float& out = messages_[e.out + b];
        change = std::max(change, std::abs(fresh_[b] - least - out));
        out = fresh_[b] - least;
      }
    }
    return change;
  }

  std::vector<std::size_t> order_;         // pieces
  std::vector<std::vector<float>> unary_;  // these and all below by place in that order
  std::vector<std::vector<End>> ends_;
  std::vector<float> costs_, messages_;
  std::vector<float> belief_, fresh_;  // of the piece and the message at work
};

}  // namespace

std::vector<int> PassMessages(const std::vector<JointPiece>& pieces, const JointGraph& graph,
                              const MessagePassingOptions& options) {
  Messages messages(pieces, graph);
  for (int sweep = 0; sweep < options.max_sweeps; ++sweep) {
    if (messages.Sweep(sweep % 2 == 0) < options.tolerance) break;
  }
  return messages.Choose();
}

}  // namespace dorsum
