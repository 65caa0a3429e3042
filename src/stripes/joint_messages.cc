// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace dorsum {
namespace {

constexpr std::size_t kLanes = 4;  // candidates that are worked on together
constexpr float kNever =
    1e30F;  // cost of what fills up the lanes: more than all others, and of no digit of theirs

// One end of an edge, seen from its piece.
struct End {
  std::uint32_t other = 0;        // the piece at the other end
  std::uint32_t in = 0, out = 0;  // where its messages to this piece and back begin
  std::uint32_t cost = 0;         // where the edge's costs begin, by candidate of this piece
};

// The graph in flat arrays, with its pieces in the order of the sweeps. Whatever belongs to a piece's
// candidates takes as many places for each piece.
class Messages {
 public:
  Messages(const std::vector<JointPiece>& pieces, const JointGraph& graph) : ends_(pieces.size()) {
    std::vector<std::size_t> place(pieces.size());
    order_.resize(pieces.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto column = [&](std::size_t i) {
      const auto& s = pieces[i].samples;
      return s.empty() ? 0.0F : s[s.size() / 2].u;
    };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return column(a) < column(b); });
    std::size_t most = 1;
    for (const auto& costs : graph.unary) most = std::max(most, costs.size());
    wide_ = (most + kLanes - 1) / kLanes * kLanes;
    unary_.assign(pieces.size() * wide_, kNever);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      place[order_[k]] = k;
      const std::vector<float>& costs = graph.unary[order_[k]];
      std::copy(costs.begin(), costs.end(), &unary_[k * wide_]);
      candidates_.push_back(costs.size());
    }
    // What a piece reads lies together: the messages to it, and its edges' costs.
    std::vector<std::vector<std::size_t>> edges_of(pieces.size());
    for (std::size_t k = 0; k < graph.edges.size(); ++k) {
      const std::size_t a = place[static_cast<std::size_t>(graph.edges[k].first)],
                        b = place[static_cast<std::size_t>(graph.edges[k].second)];
      if (candidates_[a] == 0 || candidates_[b] == 0) continue;
      edges_of[a].push_back(k);
      edges_of[b].push_back(k);
    }
    std::vector<std::array<std::uint32_t, 2>> to(
        graph.edges.size());  // where the messages to an edge's ends begin
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const std::size_t k : edges_of[i]) {
        const bool is_first = place[static_cast<std::size_t>(graph.edges[k].first)] == i;
        to[k][is_first ? 0 : 1] = AddMessage(candidates_[i]);
      }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const std::size_t k : edges_of[i]) {
        const JointEdge& e = graph.edges[k];
        const std::size_t a = place[static_cast<std::size_t>(e.first)],
                          b = place[static_cast<std::size_t>(e.second)];
        const bool is_first = a == i;
        ends_[i].push_back({static_cast<std::uint32_t>(is_first ? b : a), to[k][is_first ? 0 : 1],
                            to[k][is_first ? 1 : 0], AddCosts(e, candidates_[a], candidates_[b], is_first)});
      }
    }
    belief_.resize(wide_);
    fresh_.resize(wide_);
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
      if (candidates_[i] == 0) continue;
      std::vector<float> cost(&unary_[i * wide_], &unary_[i * wide_] + candidates_[i]);
      for (const End& e : ends_[i]) {
        for (std::size_t a = 0; a < cost.size(); ++a) {
          cost[a] += e.other < i ? costs_[e.cost + a * wide_ + static_cast<std::size_t>(chosen[e.other])]
                                 : messages_[e.in + a];
        }
      }
      chosen[i] = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
      by_piece[order_[i]] = chosen[i];
    }
    return by_piece;
  }

 private:
  std::uint32_t AddMessage(std::size_t candidates) {
    const std::size_t at = messages_.size();
    messages_.resize(at + wide_, kNever);
    std::fill_n(&messages_[at], candidates, 0.0F);
    return static_cast<std::uint32_t>(at);
  }

  // An edge's costs by the candidates of its first or its second piece, which have `n` and `m`.
  std::uint32_t AddCosts(const JointEdge& e, std::size_t n, std::size_t m, bool by_first) {
    const std::size_t at = costs_.size();
    costs_.resize(at + (by_first ? n : m) * wide_, kNever);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < m; ++j)
        costs_[at + (by_first ? i * wide_ + j : j * wide_ + i)] = e.heights[i * m + j] + e.orders[i * m + j];
    }
    return static_cast<std::uint32_t>(at);
  }

  // Calls body(place) for all lanes' places, in steps that are vectorised.
  template <class Body>
  void ForLanes(const Body& body) const {
    for (std::size_t first = 0; first < wide_; first += kLanes) {
      for (std::size_t b = first; b < first + kLanes; ++b) body(b);
    }
  }

  float SendFrom(std::size_t i, bool ahead) {
    float *belief = belief_.data(), *fresh = fresh_.data();
    ForLanes([&](std::size_t a) { belief[a] = unary_[i * wide_ + a]; });
    const std::size_t n = candidates_[i];
    int before = 0, behind = 0;
    for (const End& e : ends_[i]) {
      const float* in = &messages_[e.in];
      ForLanes([&](std::size_t a) { belief[a] += in[a]; });
      ++(e.other < i ? before : behind);
    }
    const float share = 1.0F / static_cast<float>(std::max({before, behind, 1}));
    ForLanes([&](std::size_t a) { belief[a] *= share; });
    float change = 0.0F;
    for (const End& e : ends_[i]) {
      if ((e.other > i) != ahead) continue;
      const float *in = &messages_[e.in], *cost = &costs_[e.cost];
      ForLanes([&](std::size_t b) { fresh[b] = std::numeric_limits<float>::max(); });
      for (std::size_t a = 0; a < n; ++a, cost += wide_) {
        const float base = belief[a] - in[a];
        ForLanes([&](std::size_t b) { fresh[b] = std::min(fresh[b], base + cost[b]); });
      }
      float least = fresh[0];
      for (std::size_t b = 1; b < wide_; ++b) least = std::min(least, fresh[b]);
      float* out = &messages_[e.out];
      for (std::size_t b = 0; b < wide_; ++b) {
        const float now = fresh[b] - least;
        change = std::max(change, std::abs(now - out[b]));
        out[b] = now;
      }
    }
    return change;
  }

  std::vector<std::size_t> order_;  // pieces
  std::size_t wide_ = kLanes;       // places for a piece's candidates
  std::vector<std::size_t> candidates_;
  std::vector<float> unary_;  // these and all below by place in that order
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
