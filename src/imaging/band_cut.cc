// SPDX-License-Identifier: Apache-2.0
#include "imaging/band_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "imaging/grid_cut.h"
#include "imaging/seed_map.h"
#include "imaging/sharp_step.h"

namespace dorsum {
namespace {

constexpr float kUnit = 1000.0F;  // whole numbers in the graph for 1 px of outline: sums are exact
constexpr float kCheapest = 0.002F;

struct Step {
  int du, dv;
  float length;  // of outline that the edge stands for, px
};

constexpr float kStraight = static_cast<float>(std::numbers::pi / 8.0);
constexpr float kDiagonal = kStraight / std::numbers::sqrt2_v<float>;
constexpr std::array<Step, 4> kSteps = {
    {{1, 0, kStraight}, {0, 1, kStraight}, {1, 1, kDiagonal}, {-1, 1, kDiagonal}}};

inline int Cost(float step, float texture, float length) {
  const float edge = step / texture;
  return static_cast<int>(kUnit * length * std::max(kCheapest, 1.0F / (1.0F + edge * edge)));
}

// Unknown pixels of a row that follow each other.
struct Run {
  int first, end;
};

// The run at or after column u; an empty one if there is none.
Run NextRun(const std::uint8_t* known, int u, int end) {
  const auto* first = std::find(known + u, known + end, kUnknownPixel);
  const auto* last = std::find_if(first, known + end, [](std::uint8_t k) { return k != kUnknownPixel; });
  return {static_cast<int>(first - known), static_cast<int>(last - known)};
}

template <class Body>
void ForRuns(const cv::Mat& known, int v, Body body) {
  const auto* row = known.ptr<std::uint8_t>(v);
  for (Run run = NextRun(row, 0, known.cols); run.first < run.end; run = NextRun(row, run.end, known.cols)) {
    body(run);
  }
}

class BandGraph {
 public:
  BandGraph(const BandCut& input, const Context& context)
      : in_(input),
        context_(context),
        starts_(static_cast<std::size_t>(input.known.rows) + 1, 0),
        node_(input.known.size(), CV_32SC1) {
    ForRows([&](int v) {
      ForRuns(in_.known, v,
              [&](Run run) { starts_[static_cast<std::size_t>(v) + 1] += run.end - run.first; });
    });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    ForRows([&](int v) {
      int node = starts_[static_cast<std::size_t>(v)];
      ForRuns(in_.known, v, [&](Run run) {
        std::iota(node_.ptr<int>(v) + run.first, node_.ptr<int>(v) + run.end, node);
        node += run.end - run.first;
      });
    });
  }

  cv::Mat Cut() {
    GridCut cut(static_cast<std::size_t>(starts_.back()));
    ForBlocks([&](int first, int end) {
      Costs costs;
      for (int v = first; v < end; ++v) {
        ForRuns(in_.known, v, [&](Run run) { JoinRun(v, run, &costs, &cut); });
      }
    });
    cut.Run(context_);
    cv::Mat object(in_.known.size(), CV_8UC1);
    ForRows([&](int v) {
      const auto* known = in_.known.ptr<std::uint8_t>(v);
      auto* out = object.ptr<std::uint8_t>(v);
      std::transform(known, known + object.cols, out,
                     [](std::uint8_t k) { return k == kObjectPixel ? std::uint8_t{255} : std::uint8_t{0}; });
      ForRuns(in_.known, v, [&](Run run) {
        for (int u = run.first; u < run.end; ++u) out[u] = cut.IsFirst(Node({u, v})) ? 255 : 0;
      });
    });
    return object;
  }

 private:
  // Of a run's pixels.
  struct Costs {
    std::vector<float> texture;
    std::array<std::vector<int>, kSteps.size()> forward;  // of each step from there
  };

  void ForBlocks(const std::function<void(int, int)>& body) const {
    constexpr int kRows = 16;
    ParallelFor(context_, 0, (node_.rows + kRows - 1) / kRows, [&](std::int64_t block) {
      const int first = static_cast<int>(block) * kRows;
      body(first, std::min(node_.rows, first + kRows));
    });
  }
  template <class Body>
  void ForRows(Body body) const {
    ForBlocks([&](int first, int end) {
      for (int v = first; v < end; ++v) body(v);
    });
  }

  int Node(cv::Point p) const { return node_.ptr<int>(p.y)[p.x]; }

  int StepCost(cv::Point p, cv::Point way, float texture, float length) const {
    return Cost(SharpStep(in_.light, p, way), texture, length);
  }

  void FindCosts(int v, Run run, Costs* costs) const {
    const auto count = static_cast<std::size_t>(run.end - run.first);
    costs->texture.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      costs->texture[i] = in_.texture.At(run.first + static_cast<int>(i), v);
    const bool inner =
        HasSlopes(in_.light.size(), {run.first, v}) && HasSlopes(in_.light.size(), {run.end - 1, v});
    for (std::size_t s = 0; s < kSteps.size(); ++s) {
      costs->forward[s].resize(count);
      if (inner) {
        const auto stride = static_cast<std::ptrdiff_t>(in_.light.step1());
        InnerCosts(in_.light.ptr<float>(v) + run.first, kSteps[s].dv * stride + kSteps[s].du,
                   kSteps[s].length, costs->texture, costs->forward[s].data());
        continue;
      }
      for (std::size_t i = 0; i < count; ++i) {
        const cv::Point p(run.first + static_cast<int>(i), v), way(kSteps[s].du, kSteps[s].dv);
        if (Contains(p + way)) costs->forward[s][i] = StepCost(p, way, costs->texture[i], kSteps[s].length);
      }
    }
  }

  static void InnerCosts(const float* light, std::ptrdiff_t way, float length,
                         const std::vector<float>& texture, int* out) {
    for (std::size_t i = 0; i < texture.size(); ++i) {
      out[i] = Cost(SharpStep(light + i, way), texture[i], length);
    }
  }

  bool Contains(cv::Point p) const { return cv::Rect({0, 0}, node_.size()).contains(p); }

  // What parts the pixel from a known neighbour.
  int KnownPull(cv::Point neighbour, int cost) const {
    return in_.known.ptr<std::uint8_t>(neighbour.y)[neighbour.x] == kObjectPixel ? cost : -cost;
  }
  bool IsKnown(cv::Point p) const { return in_.known.ptr<std::uint8_t>(p.y)[p.x] != kUnknownPixel; }

  void JoinRun(int v, Run run, Costs* costs, GridCut* cut) const {
    FindCosts(v, run, costs);
    for (int u = run.first; u < run.end; ++u) {
      const auto i = static_cast<std::size_t>(u - run.first);
      const cv::Point pixel(u, v);
      int pull = static_cast<int>(std::lround(kUnit * in_.pull.ptr<float>(v)[u]));
      for (std::size_t s = 0; s < kSteps.size(); ++s) {
        const cv::Point way(kSteps[s].du, kSteps[s].dv), next = pixel + way, last = pixel - way;
        const int cost = costs->forward[s][i];
        if (Contains(next)) {
          if (IsKnown(next)) {
            pull += KnownPull(next, cost);
          } else {
            cut->Join(Node(pixel), Node(next), 2 * static_cast<int>(s), cost);
          }
        }
        if (Contains(last) && IsKnown(last))  // else joined from its side
          pull += KnownPull(last, StepCost(pixel, -way, costs->texture[i], kSteps[s].length));
      }
      cut->Pull(Node(pixel), pull);
    }
  }

  const BandCut& in_;
  const Context& context_;
  std::vector<int> starts_;  // each row's first node, and how many there are
  cv::Mat node_;             // CV_32SC1, of unknown pixels
};

}  // namespace

cv::Mat CutInBand(const BandCut& input, const Context& context) { return BandGraph(input, context).Cut(); }

}  // namespace dorsum
