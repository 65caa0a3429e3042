// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_inference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace dorsum {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// What a piece costs that a move of its surface leaves without a candidate, for each observation.
constexpr double kNoCandidateCost = 4.0;

class Inference {
 public:
  Inference(const std::vector<JointPiece>& pieces, const JointGraph& graph,
            const JointInferenceOptions& options, const Context& context)
      : pieces_(pieces), graph_(graph), options_(options), at_(pieces.size()) {
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      at_[static_cast<std::size_t>(graph.edges[e].first)].push_back(static_cast<int>(e));
      at_[static_cast<std::size_t>(graph.edges[e].second)].push_back(static_cast<int>(e));
    }
    labels_.candidate = PassMessages(pieces, graph, options.messages, context);
    labels_.own_margin.assign(pieces.size(), 0.0);
    labels_.surface_margin.assign(pieces.size(), 0.0);
    labels_.surface.assign(pieces.size(), 0);
  }

  JointLabels Run() {
    Polish();
    for (int round = 0; round < options_.cluster_rounds; ++round) {
      FindSurfaces();
      bool moved = false;
      for (const std::vector<int>& surface : surfaces_) moved |= MoveSurface(surface);
      if (!moved) break;
      Polish();
    }
    FindSurfaces();
    for (std::size_t i = 0; i < pieces_.size(); ++i) labels_.own_margin[i] = OwnMargin(static_cast<int>(i));
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      const double margin = std::min(MoveCost(surfaces_[s], -1), MoveCost(surfaces_[s], 1));
      for (const int i : surfaces_[s]) {
        labels_.surface[U(i)] = static_cast<int>(s);
        labels_.surface_margin[U(i)] = margin;
      }
    }
    return std::move(labels_);
  }

 private:
  static std::size_t U(int i) { return static_cast<std::size_t>(i); }
  int Count(int i) const { return pieces_[U(i)].candidates; }
  static int Other(const JointEdge& e, int i) { return e.first == i ? e.second : e.first; }
  // Place in the tables of an edge with `i` having `a` and its other end `b`.
  std::size_t Place(const JointEdge& e, int i, int a, int b) const {
    return e.first == i ? U(a) * U(Count(e.second)) + U(b) : U(b) * U(Count(e.second)) + U(a);
  }
  float EdgeCost(const JointEdge& e, int i, int a, int b) const {
    const std::size_t k = Place(e, i, a, b);
    return e.heights[k] + e.orders[k];
  }

  // Cost of all that depends on piece i, having candidate a.
  double LocalCost(int i, int a) const {
    double cost = graph_.unary[U(i)][U(a)];
    for (const int e : at_[U(i)]) {
      const int j = Other(graph_.edges[U(e)], i);
      if (labels_.candidate[U(j)] >= 0) cost += EdgeCost(graph_.edges[U(e)], i, a, labels_.candidate[U(j)]);
    }
    return cost;
  }

  // Moves single pieces as long as that costs less.
  void Polish() {
    for (int round = 0; round < 20; ++round) {
      bool moved = false;
      for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
        if (Count(i) < 2) continue;
        int best = labels_.candidate[U(i)];
        double least = LocalCost(i, best) - 1e-6;
        for (int a = 0; a < Count(i); ++a) {
          const double cost = LocalCost(i, a);
          if (cost < least) {
            least = cost;
            best = a;
          }
        }
        moved |= best != labels_.candidate[U(i)];
        labels_.candidate[U(i)] = best;
      }
      if (!moved) break;
    }
  }

  double OwnMargin(int i) const {
    const int own = labels_.candidate[U(i)];
    if (own < 0) return 0.0;
    double margin = kInfinite;
    for (int a = 0; a < Count(i); ++a) {
      if (a != own) margin = std::min(margin, LocalCost(i, a));
    }
    return margin - LocalCost(i, own);
  }

  // Pieces that lie smoothly beside each other are one surface.
  void FindSurfaces() {
    std::vector<int> root(pieces_.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int i) {
      while (root[U(i)] != i) i = root[U(i)] = root[U(root[U(i)])];
      return i;
    };
    for (const JointEdge& e : graph_.edges) {
      const int a = labels_.candidate[U(e.first)], b = labels_.candidate[U(e.second)];
      if (a < 0 || b < 0 || e.observations <= 0.0) continue;
      if (EdgeCost(e, e.first, a, b) > options_.smooth_cost * e.observations) continue;
      const int x = find(e.first), y = find(e.second);
      root[U(std::max(x, y))] = std::min(x, y);
    }
    std::vector<int> index(pieces_.size(), -1);
    surfaces_.clear();
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
      if (labels_.candidate[U(i)] < 0) continue;
      const int r = find(i);
      if (index[U(r)] < 0) {
        index[U(r)] = static_cast<int>(surfaces_.size());
        surfaces_.emplace_back();
      }
      surfaces_[U(index[U(r)])].push_back(i);
    }
  }

  // What it adds to the total cost to move all pieces of a surface up (1) or down (-1) by one order. Heights
  // across the surface's edges count for little, however long these are: how high a step is says hardly
  // anything, and whether the lasers' stripes interleave smoothly inside says much.
  double MoveCost(const std::vector<int>& surface, int by) {
    inside_.resize(pieces_.size(), 0);
    for (const int i : surface) inside_[U(i)] = 1;
    const auto moved = [&](int i) {
      const int k = labels_.candidate[U(i)] + (inside_[U(i)] != 0 ? by : 0);
      return k >= 0 && k < Count(i) ? k : -1;
    };
    double cost = 0.0, steps = 0.0;
    for (const int i : surface) {
      const int a = labels_.candidate[U(i)], b = moved(i);
      cost += b < 0 ? kNoCandidateCost * graph_.observations[U(i)]
                    : graph_.unary[U(i)][U(b)] - graph_.unary[U(i)][U(a)];
      for (const int e : at_[U(i)]) {
        const JointEdge& edge = graph_.edges[U(e)];
        const int j = Other(edge, i);
        if (labels_.candidate[U(j)] < 0 || (inside_[U(j)] != 0 && j < i)) continue;
        const int to = moved(j);
        if (b < 0 || to < 0) continue;
        const std::size_t was = Place(edge, i, a, labels_.candidate[U(j)]), is = Place(edge, i, b, to);
        cost += edge.orders[is] - edge.orders[was];
        (inside_[U(j)] != 0 ? cost : steps) += edge.heights[is] - edge.heights[was];
      }
    }
    for (const int i : surface) inside_[U(i)] = 0;
    return cost + std::clamp(steps, -options_.most_for_steps, options_.most_for_steps);
  }

  bool MoveSurface(const std::vector<int>& surface) {
    const double down = MoveCost(surface, -1), up = MoveCost(surface, 1);
    if (std::min(down, up) >= -1e-6) return false;
    const int by = down < up ? -1 : 1;
    for (const int i : surface) {
      labels_.candidate[U(i)] = std::clamp(labels_.candidate[U(i)] + by, 0, Count(i) - 1);
    }
    return true;
  }

  const std::vector<JointPiece>& pieces_;
  const JointGraph& graph_;
  const JointInferenceOptions& options_;
  std::vector<std::vector<int>> at_;  // edges of each piece
  std::vector<std::vector<int>> surfaces_;
  std::vector<char> inside_;  // 1: in the surface that is looked at
  JointLabels labels_;
};

}  // namespace

JointLabels InferLabels(const std::vector<JointPiece>& pieces, const JointGraph& graph,
                        const JointInferenceOptions& options, const Context& context) {
  return Inference(pieces, graph, options, context).Run();
}

}  // namespace dorsum
