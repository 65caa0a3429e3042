// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/parallel.h"

namespace dorsum {
namespace {

// A sample of a piece, in the list of its row.
struct Here {
  float u = 0.0F;
  int piece = 0, sample = 0;
};
// By image row, from 0 on.
using Rows = std::vector<std::vector<Here>>;

Rows SortIntoRows(const std::vector<JointPiece>& pieces, const Context& context) {
  Rows rows;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t s = 0; s < pieces[i].samples.size(); ++s) {
      const auto v = static_cast<std::size_t>(std::max(0L, std::lround(pieces[i].samples[s].v)));
      if (v >= rows.size()) rows.resize(v + 1);
      rows[v].push_back({pieces[i].samples[s].u, static_cast<int>(i), static_cast<int>(s)});
    }
  }
  ParallelFor(context, 0, static_cast<std::int64_t>(rows.size()), [&](std::int64_t v) {
    std::vector<Here>& row = rows[static_cast<std::size_t>(v)];
    std::sort(row.begin(), row.end(),
              [](const Here& a, const Here& b) { return std::pair(a.u, a.piece) < std::pair(b.u, b.piece); });
  });
  return rows;
}

// most * (1 - (1 + t^2)^(-1 / most)) of a height difference of t scales, from tables.
class StepCost {
 public:
  explicit StepCost(double most) {
    const auto cost = [&](double t) {
      return static_cast<float>(most * (1.0 - std::pow(1.0 + t * t, -1.0 / most)));
    };
    for (std::size_t i = 0; i <= kCount; ++i) {
      fine_[i] = cost(static_cast<double>(i) / kFine);
      coarse_[i] = cost(static_cast<double>(i) / kCoarse);
    }
  }
  float operator()(float t) const {
    return t < kCount / kFine ? At(fine_, t * kFine) : At(coarse_, std::min(t * kCoarse, 1.0F * kCount));
  }

 private:
  static constexpr std::size_t kCount = 1024;
  static constexpr float kFine = 64.0F, kCoarse = 2.0F;  // steps for a scale
  using Table = std::array<float, kCount + 1>;
  static float At(const Table& table, float x) {
    const auto i = std::min(static_cast<std::size_t>(x), kCount - 1);
    return table[i] + (x - static_cast<float>(i)) * (table[i + 1] - table[i]);
  }
  Table fine_{}, coarse_{};
};

class Builder {
 public:
  Builder(const std::vector<JointPiece>& pieces, const JointGraphOptions& options)
      : pieces_(pieces), options_(options), step_cost_(options.most_cost), edges_of_(pieces.size()) {}

  // Adds one comparison of two samples that are `distance` apart, mm.
  void Compare(const Here& a, const Here& b, double distance, double observations) {
    JointEdge& edge = edges_[EdgeOf(a.piece, b.piece)];
    edge.observations += observations;
    const JointPiece &p = pieces_[static_cast<std::size_t>(edge.first)],
                     &q = pieces_[static_cast<std::size_t>(edge.second)];
    const bool swapped = edge.first != a.piece;
    const std::span<const float> z(p.Heights(U(swapped ? b.sample : a.sample)), U(p.candidates));
    const std::span<const float> y(q.Heights(U(swapped ? a.sample : b.sample)), U(q.candidates));
    const auto unit = static_cast<float>(1.0 / (options_.scale_mm + options_.scale_slope * distance));
    const auto weight = static_cast<float>(observations);
    constexpr float kUnseen = 40.0F;  // mm; what a height counts as that cannot be
    float* cost = edge.heights.data();
    for (const float zi : z) {
      for (const float yj : y) {
        const float d = std::isnan(zi) || std::isnan(yj) ? kUnseen : std::abs(zi - yj);
        *cost++ += weight * step_cost_(d * unit);
      }
    }
  }

  // `left` and `right`, of one laser, share a row: the order of `left` is the lower one.
  void Order(int left, int right, int rows) {
    rules_[EdgeOf(left, right)].grows += left < right ? rows : -rows;
  }

  // Adds what another builder for the same pieces has found.
  void Add(const Builder& other) {
    for (std::size_t e = 0; e < other.edges_.size(); ++e) {
      const JointEdge& from = other.edges_[e];
      const std::size_t own = EdgeOf(from.first, from.second);
      JointEdge& to = edges_[own];
      to.observations += from.observations;
      for (std::size_t k = 0; k < to.heights.size(); ++k) to.heights[k] += from.heights[k];
      rules_[own].grows += other.rules_[e].grows;
    }
  }

  void Continue(int above, int below, double cost) { rules_[EdgeOf(above, below)].change_cost = cost; }

  std::vector<JointEdge> Finish(const Context& context) {
    ParallelFor(context, 0, static_cast<std::int64_t>(edges_.size()), [&](std::int64_t at) {
      const auto e = static_cast<std::size_t>(at);
      JointEdge& edge = edges_[e];
      const Rule& rule = rules_[e];
      if (edge.observations > options_.most_observations) {
        const double share = options_.most_observations / edge.observations;
        for (float& c : edge.heights) c *= static_cast<float>(share);
        edge.observations = options_.most_observations;
      }
      const JointPiece &p = pieces_[U(edge.first)], &q = pieces_[U(edge.second)];
      const double crossing =
          std::clamp((std::abs(rule.grows) - options_.crossing_free_rows) / options_.crossing_rows, 0.0, 1.0);
      std::size_t k = 0;
      for (int a = 0; a < p.candidates; ++a) {
        for (int b = 0; b < q.candidates; ++b, ++k) {
          const int grows = q.Order(b) - p.Order(a);
          double cost = grows != 0 ? rule.change_cost : 0.0;
          if (rule.grows != 0 && rule.grows * grows <= 0) {
            cost += options_.crossing_cost * crossing;
          }
          edge.orders[k] = static_cast<float>(cost);
        }
      }
    });
    return std::move(edges_);
  }

 private:
  // What is asked of the orders at an edge's ends.
  struct Rule {
    int grows = 0;  // rows in which the second's must be larger; negative: smaller
    double change_cost = 0.0;
  };
  static std::size_t U(int i) { return static_cast<std::size_t>(i); }

  std::size_t EdgeOf(int a, int b) {
    const int low = std::min(a, b), high = std::max(a, b);
    for (const auto& [other, e] : edges_of_[U(low)]) {
      if (other == high) return e;
    }
    edges_of_[U(low)].emplace_back(high, edges_.size());
    const std::size_t size = U(pieces_[U(low)].candidates) * U(pieces_[U(high)].candidates);
    edges_.push_back({low, high, 0.0, std::vector<float>(size, 0.0F), std::vector<float>(size, 0.0F)});
    rules_.emplace_back();
    return edges_.size() - 1;
  }

  const std::vector<JointPiece>& pieces_;
  const JointGraphOptions& options_;
  const StepCost step_cost_;
  std::vector<JointEdge> edges_;
  std::vector<Rule> rules_;  // by edge
  std::vector<std::vector<std::pair<int, std::size_t>>>
      edges_of_;  // by the lower piece: the higher one and the edge
};

// Surfaces are smooth, so every second of the rows with samples tells as much as all.
constexpr int kSkip = 2;

// Stripes side by side in the rows [first, end).
void CompareAlongRows(const std::vector<JointPiece>& pieces, const Rows& rows, std::size_t first,
                      std::size_t end, int sample_rows, double observations, const JointGraphOptions& options,
                      Builder* builder) {
  for (std::size_t v = first; v < end; ++v) {
    if (v / static_cast<std::size_t>(sample_rows) % kSkip != 0) continue;
    const std::vector<Here>& row = rows[v];
    for (std::size_t i = 0; i < row.size(); ++i) {
      const JointPiece& p = pieces[static_cast<std::size_t>(row[i].piece)];
      bool met_own = false;
      for (std::size_t j = i + 1; j < row.size() && j <= i + 2U * static_cast<unsigned>(options.neighbours);
           ++j) {
        if (row[j].piece == row[i].piece) continue;
        const JointPiece& q = pieces[static_cast<std::size_t>(row[j].piece)];
        const double distance = (row[j].u - row[i].u) / p.px_per_mm;
        if (p.laser == q.laser && !met_own) {
          met_own = true;
          if (distance < 6.0 * options.max_distance_mm)
            builder->Order(row[i].piece, row[j].piece, kSkip * sample_rows);
        }
        if (distance <= options.max_distance_mm && j <= i + static_cast<unsigned>(options.neighbours)) {
          builder->Compare(row[i], row[j], distance, kSkip * observations);
        }
      }
    }
  }
}

// Another piece's sample that faces the end of a piece.
struct Facing {
  double distance = 0.0;  // mm
  Here at;
};

// The nearest sample of each of the nearest few other pieces above (`way` -1) or below (1) a sample.
std::vector<Facing> FindFacing(const Rows& rows, const JointSample& from, int piece, int way, float px_per_mm,
                               double max_gap_mm) {
  constexpr std::size_t kFew = 4;
  const float reach = static_cast<float>(max_gap_mm) * px_per_mm, half = 0.7F * reach;
  const int v0 = static_cast<int>(std::lround(from.v));
  std::vector<Facing> few;  // by growing distance
  for (int rise = 1; rise <= static_cast<int>(reach); ++rise) {
    const int v = v0 + way * rise;
    if (v < 0 || v >= static_cast<int>(rows.size())) break;
    if (few.size() == kFew && rise / px_per_mm > few.back().distance) break;
    const std::vector<Here>& row = rows[static_cast<std::size_t>(v)];
    auto h = std::lower_bound(row.begin(), row.end(), from.u - half,
                              [](const Here& a, float u) { return a.u < u; });
    for (; h != row.end() && h->u <= from.u + half; ++h) {
      const float du = h->u - from.u, dv = static_cast<float>(rise);
      const double distance = std::sqrt(du * du + dv * dv) / px_per_mm;
      if (h->piece == piece || distance > max_gap_mm) continue;
      const auto known =
          std::find_if(few.begin(), few.end(), [&](const Facing& f) { return f.at.piece == h->piece; });
      if (known != few.end()) {
        if (known->distance <= distance) continue;
        few.erase(known);
      }
      const auto behind = std::upper_bound(few.begin(), few.end(), distance,
                                           [](double d, const Facing& f) { return d < f.distance; });
      few.insert(behind, {distance, *h});
      if (few.size() > kFew) few.pop_back();
    }
  }
  return few;
}

// Ends of stripes, those of the pieces [first, last), that face other stripes along the columns.
void CompareAlongColumns(const std::vector<JointPiece>& pieces, const Rows& rows, std::size_t first,
                         std::size_t last, double observations, const JointGraphOptions& options,
                         Builder* builder) {
  for (std::size_t i = first; i < last; ++i) {
    const JointPiece& p = pieces[i];
    if (p.samples.empty()) continue;
    for (const int way : {-1, 1}) {
      const std::size_t end = way < 0 ? 0 : p.samples.size() - 1;
      const int own = static_cast<int>(i);
      for (const Facing& to : FindFacing(rows, p.samples[end], own, way, p.px_per_mm, options.max_gap_mm)) {
        builder->Compare({p.samples[end].u, own, static_cast<int>(end)}, to.at, to.distance, observations);
      }
    }
  }
}

std::vector<float> UnaryCosts(const JointPiece& p, double low, double high, double observations,
                              const JointGraphOptions& options) {
  std::vector<float> cost;
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.candidates); ++k) {
    double outside = 0.0, on_backplane = 0.0;
    for (std::size_t i = 0; i < p.samples.size(); ++i) {
      const auto z = static_cast<double>(p.Heights(i)[k]);
      const double excess = std::isnan(z) ? 10.0 : std::max(low - z, z - high) - options.volume_tolerance_mm;
      outside += std::clamp(excess / options.volume_tolerance_mm, 0.0, 1.0);
      if (!std::isnan(z))
        on_backplane += std::clamp(2.0 - std::abs(z) / options.backplane_tolerance_mm, 0.0, 1.0);
    }
    const auto n = static_cast<double>(p.samples.size());
    double c = options.volume_cost * observations * outside / n;
    // A piece that lies on the backplane does so all along.
    c -= (options.backplane_start + options.backplane_bonus * observations) *
         std::max(0.0, 2.0 * on_backplane / n - 1.0);
    cost.push_back(static_cast<float>(c));
  }
  return cost;
}

}  // namespace

JointGraph BuildJointGraph(const std::vector<JointPiece>& pieces, int sample_rows, double min_height_mm,
                           double max_height_mm, const JointGraphOptions& options, const Context& context) {
  JointGraph graph;
  const double each = sample_rows / options.independent_rows;
  graph.observations.resize(pieces.size());
  graph.unary.resize(pieces.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(pieces.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    const JointPiece& p = pieces[k];
    const double n = std::min(options.most_observations, each * static_cast<double>(p.samples.size()));
    graph.observations[k] = n;
    graph.unary[k] = UnaryCosts(p, min_height_mm, max_height_mm, n, options);
  });
  const Rows rows = SortIntoRows(pieces, context);
  // Bands of rows, and parts of the pieces, side by side; always as many, so that sums come out the same.
  constexpr std::size_t kBands = 4;
  std::vector<Builder> bands(kBands, Builder(pieces, options));
  ParallelFor(context, 0, kBands, [&](std::int64_t band) {
    const auto k = static_cast<std::size_t>(band);
    CompareAlongRows(pieces, rows, k * rows.size() / kBands, (k + 1) * rows.size() / kBands, sample_rows,
                     each, options, &bands[k]);
    CompareAlongColumns(pieces, rows, k * pieces.size() / kBands, (k + 1) * pieces.size() / kBands, each,
                        options, &bands[k]);
  });
  Builder& builder = bands[0];
  for (std::size_t k = 1; k < kBands; ++k) builder.Add(bands[k]);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].laser != pieces[i - 1].laser || pieces[i].segment != pieces[i - 1].segment) continue;
    builder.Continue(static_cast<int>(i - 1), static_cast<int>(i),
                     pieces[i].follows ? options.cut_cost : options.kink_cost);
  }
  graph.edges = builder.Finish(context);
  return graph;
}

}  // namespace dorsum
