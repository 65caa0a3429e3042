// SPDX-License-Identifier: Apache-2.0
#include "imaging/band_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

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

class BandGraph {
 public:
  explicit BandGraph(const BandCut& input)
      : in_(input),
        texture_scale_(input.texture.rows == input.known.rows ? 1 : 2),
        node_(input.known.size(), -1) {
    for (int v = 0; v < node_.rows; ++v) {
      const auto* known = in_.known.ptr<std::uint8_t>(v);
      for (int u = 0; u < node_.cols; ++u) {
        if (known[u] != kUnknownPixel) continue;
        node_(v, u) = static_cast<int>(pixels_.size());
        pixels_.emplace_back(u, v);
      }
    }
  }

  cv::Mat Cut() {
    cv::Mat object = in_.known == kObjectPixel;
    GridCut cut(pixels_.size());
    for (const cv::Point pixel : pixels_) Join(pixel, &cut);
    cut.Run();
    for (const cv::Point pixel : pixels_) {
      if (cut.IsFirst(node_(pixel))) object.at<std::uint8_t>(pixel) = 255;
    }
    return object;
  }

 private:
  int Cost(cv::Point p, cv::Point q, float length) const {
    const float step = SharpStep(in_.light, p, q - p) /
                       in_.texture.at<float>(cv::Point(p.x / texture_scale_, p.y / texture_scale_));
    return static_cast<int>(kUnit * length * std::max(kCheapest, 1.0F / (1.0F + step * step)));
  }

  void Join(cv::Point pixel, GridCut* cut) const {
    const int node = node_(pixel);
    const cv::Rect image({0, 0}, node_.size());
    cut->Pull(node, static_cast<int>(std::lround(kUnit * in_.pull.at<float>(pixel))));
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      const Step& step = kSteps[i];
      for (const int sign : {1, -1}) {
        const cv::Point neighbour = pixel + sign * cv::Point(step.du, step.dv);
        if (!image.contains(neighbour)) continue;
        const int other = node_(neighbour);
        if (other >= 0 && sign < 0) continue;  // joined from its side
        const int cost = Cost(pixel, neighbour, step.length);
        if (other >= 0) {
          cut->Join(node, other, 2 * static_cast<int>(i), cost);
        } else {
          cut->Pull(node, in_.known.at<std::uint8_t>(neighbour) == kObjectPixel ? cost : -cost);
        }
      }
    }
  }

  const BandCut& in_;
  int texture_scale_;
  cv::Mat_<int> node_;  // -1 where the pixel is known
  std::vector<cv::Point> pixels_;
};

}  // namespace

cv::Mat CutInBand(const BandCut& input) { return BandGraph(input).Cut(); }

}  // namespace dorsum
