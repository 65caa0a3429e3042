// SPDX-License-Identifier: Apache-2.0
#include "imaging/band_cut.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

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

class BandGraph {
 public:
  explicit BandGraph(const BandCut& input) : in_(input), node_(input.known.size(), CV_32SC1) {
    int count = 0;
    for (int v = 0; v < node_.rows; ++v) {
      for (int u = 0; u < node_.cols; ++u) {
        node_(v, u) = in_.known.at<std::uint8_t>(v, u) == kUnknownPixel ? count++ : -1;
      }
    }
    graph_.create(static_cast<unsigned>(count), static_cast<unsigned>(8 * count));
    for (int i = 0; i < count; ++i) graph_.addVtx();
  }

  cv::Mat Cut() {
    for (int v = 0; v < node_.rows; ++v) {
      for (int u = 0; u < node_.cols; ++u) Join(u, v);
    }
    graph_.maxFlow();
    cv::Mat object = in_.known == kObjectPixel;
    for (int v = 0; v < node_.rows; ++v) {
      for (int u = 0; u < node_.cols; ++u) {
        if (node_(v, u) >= 0 && graph_.inSourceSegment(node_(v, u))) object.at<std::uint8_t>(v, u) = 255;
      }
    }
    return object;
  }

 private:
  int Cost(cv::Point p, cv::Point q, float length) const {
    const float texture = 0.5F * (in_.texture.at<float>(p) + in_.texture.at<float>(q));
    const float step = SharpStep(in_.light, p, q - p) / texture;
    return static_cast<int>(kUnit * length * std::max(kCheapest, 1.0F / (1.0F + step * step)));
  }

  void Pull(int node, int cost) { graph_.addTermWeights(node, std::max(cost, 0), std::max(-cost, 0)); }

  void Join(int u, int v) {
    const int node = node_(v, u);
    if (node >= 0) Pull(node, static_cast<int>(std::lround(kUnit * in_.pull.at<float>(v, u))));
    for (const Step& step : kSteps) {
      const int x = u + step.du, y = v + step.dv;
      if (x < 0 || x >= node_.cols || y >= node_.rows) continue;
      const int other = node_(y, x);
      if (node < 0 && other < 0) continue;
      const int cost = Cost({u, v}, {x, y}, step.length);
      if (node >= 0 && other >= 0) {
        graph_.addEdges(node, other, cost, cost);
      } else if (node >= 0) {
        Pull(node, in_.known.at<std::uint8_t>(y, x) == kObjectPixel ? cost : -cost);
      } else {
        Pull(other, in_.known.at<std::uint8_t>(v, u) == kObjectPixel ? cost : -cost);
      }
    }
  }

  const BandCut& in_;
  cv::Mat_<int> node_;
  cv::detail::GCGraph<int> graph_;
};

}  // namespace

cv::Mat CutInBand(const BandCut& input) { return BandGraph(input).Cut(); }

}  // namespace dorsum
