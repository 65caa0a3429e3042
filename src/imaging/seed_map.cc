// SPDX-License-Identifier: Apache-2.0
#include "imaging/seed_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/parallel.h"

namespace dorsum {
namespace {

// Columns of a row's seeds.
std::vector<int> SeedColumns(const cv::Mat& votes, int row) {
  std::vector<int> columns;
  const auto* line = votes.ptr<float>(row);
  for (int u = 0; u < votes.cols; ++u) {
    if (line[u] != 0.0F) columns.push_back(u);
  }
  return columns;
}

// A distance in pixels that most neighbours of a row keep.
int UsualDistance(const cv::Mat& votes, int scale) {
  constexpr double kShare = 0.9, kMargin = 1.25;
  const int largest = 100 / scale, smallest = 8 / scale;
  std::vector<int> distances;
  for (int v = 0; v < votes.rows; v += 4) {
    const std::vector<int> columns = SeedColumns(votes, v);
    for (std::size_t i = 1; i < columns.size(); ++i) distances.push_back(columns[i] - columns[i - 1]);
  }
  if (distances.empty()) return smallest;
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), middle, distances.end());
  return std::clamp(static_cast<int>(std::ceil(kMargin * *middle)), smallest, largest);
}

// Whether the light from a to b departs little from a straight line.
bool EvenLight(const float* ratio, int a, int b) {
  constexpr float kStep = 0.05F, kShare = 0.2F;  // absolute, and of the light there
  const float slope = (ratio[b] - ratio[a]) / static_cast<float>(b - a);
  const float allowed = kStep + kShare * 0.5F * (ratio[a] + ratio[b]);
  for (int u = a + 1; u < b; ++u) {
    if (std::abs(ratio[u] - ratio[a] - slope * static_cast<float>(u - a)) > allowed) return false;
  }
  return true;
}

// Marks what lies from a to b, both on the object, and is no darker than they are. A gap that narrow would be
// dark, or show a stripe.
void Bridge(const float* ratio, int a, int b, std::uint8_t* bridge) {
  const float least = 0.9F * std::min(ratio[a], ratio[b]);
  for (int u = a + 1; u < b; ++u) {
    if (ratio[u] < least) return;
  }
  std::fill(bridge + a, bridge + b, std::uint8_t{255});
}

}  // namespace

cv::Mat CountVotes(const std::vector<ObjectSeed>& seeds, cv::Size size, int scale) {
  cv::Mat votes = cv::Mat::zeros(size, CV_32FC1);
  const float shift = 0.5F * static_cast<float>(scale - 1), step = static_cast<float>(scale);
  for (const ObjectSeed& seed : seeds) {
    const auto u = std::lround((seed.u - shift) / step), v = std::lround((seed.v - shift) / step);
    if (u < 0 || v < 0 || u >= size.width || v >= size.height) continue;
    votes.at<float>(static_cast<int>(v), static_cast<int>(u)) += seed.object ? 1.0F : -1.0F;
  }
  return votes;
}

SeedMap MapSeeds(const std::vector<ObjectSeed>& seeds, const cv::Mat& ratio, int scale,
                 const Context& context) {
  SeedMap map;
  map.votes = CountVotes(seeds, ratio.size(), scale);
  map.known = cv::Mat(ratio.size(), CV_8UC1, cv::Scalar(kUnknownPixel));
  map.bridge = cv::Mat::zeros(ratio.size(), CV_8UC1);
  constexpr int kRing = 30;  // px: a ring's width
  const int farthest = UsualDistance(map.votes, scale);
  ParallelFor(context, 0, ratio.rows, [&](std::int64_t row) {
    const int v = static_cast<int>(row);
    const std::vector<int> columns = SeedColumns(map.votes, v);
    const auto* votes = map.votes.ptr<float>(v);
    const auto* light = ratio.ptr<float>(v);
    auto* known = map.known.ptr<std::uint8_t>(v);
    for (std::size_t i = 1; i < columns.size(); ++i) {
      const int a = columns[i - 1], b = columns[i];
      const bool object = votes[a] > 0.0F;
      if (object != (votes[b] > 0.0F)) continue;
      if (b - a <= farthest && EvenLight(light, a, b)) {
        std::fill(known + a, known + b, object ? kObjectPixel : kBackplanePixel);
      } else if (object && b - a <= farthest + kRing / scale) {
        Bridge(light, a, b, map.bridge.ptr<std::uint8_t>(v));
      }
    }
    // A seed stays open when its left neighbour is of the other kind: one of the two may be wrong.
    for (std::size_t i = 1; i < columns.size(); ++i) {
      const int a = columns[i - 1], b = columns[i];
      if ((votes[a] > 0.0F) != (votes[b] > 0.0F)) known[a] = known[b] = kUnknownPixel;
    }
  });
  return map;
}

}  // namespace dorsum
