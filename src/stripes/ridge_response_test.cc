// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_response.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/random.h"

namespace dorsum {
namespace {

cv::Mat1b Noise(int cols, int rows) {
  Rng rng(7);
  cv::Mat1b out(rows, cols);
  for (std::uint8_t& g : out) g = static_cast<std::uint8_t>(255.0 * rng.Uniform());
  return out;
}

// Three rows; 0.5, 0.25, -0.125, -0.375 along them.
const RidgeKernel kKernel = {{32, 16}, {16384, 8192, -4096, -12288}};

// As a fixed-point product is rounded.
int Product(int a, int b) { return (a * b + (1 << 14)) >> 15; }

TEST(RidgeResponse, IsTheKernelOverSmoothedRows) {
  for (const int cols : {1, 5, 33, 100}) {
    const cv::Mat1b green = Noise(cols, 9);
    RidgeResponse response(kKernel);
    for (const int row : {0, 1, 4, 8}) {
      response.Compute(green, row, 0, cols);
      const auto smooth = [&](int u) {
        const auto at = [&](int v) { return green(std::clamp(v, 0, 8), std::clamp(u, 0, cols - 1)); };
        return 32 * at(row) + 16 * (at(row - 1) + at(row + 1));
      };
      ASSERT_EQ(response.response().size(), static_cast<std::size_t>(cols));
      for (int u = 0; u < cols; ++u) {
        int expected = Product(kKernel.columns[0], smooth(u));
        for (int k = 1; k < 4; ++k)
          expected += Product(kKernel.columns[static_cast<std::size_t>(k)], smooth(u - k) + smooth(u + k));
        EXPECT_EQ(response.response()[static_cast<std::size_t>(u)], expected) << u << " of " << cols;
        EXPECT_EQ(response.Smoothed(static_cast<std::size_t>(u)), smooth(u));
      }
    }
  }
}

TEST(RidgeResponse, IsHeldAtTheLargestNumber) {
  cv::Mat1b green(9, 41, static_cast<std::uint8_t>(0));
  green.colRange(20, 21) = 255;
  RidgeResponse response({{64}, {32767, 32767, -32767}});
  response.Compute(green, 4, 0, green.cols);
  for (const int u : {19, 20, 21}) EXPECT_GT(response.response()[static_cast<std::size_t>(u)], 16000) << u;
  green.colRange(18, 23) = 255;
  response.Compute(green, 4, 0, green.cols);
  EXPECT_GT(response.response()[20], 0);
}

TEST(RidgeResponse, APartOfARowAnswersAsInTheWholeRow) {
  const cv::Mat1b green = Noise(100, 5);
  RidgeResponse whole(kKernel), part(kKernel);
  whole.Compute(green, 2, 0, 100);
  for (const auto& [first, end] : {std::pair{0, 40}, {1, 2}, {37, 71}, {60, 100}}) {
    part.Compute(green, 2, first, end);
    ASSERT_EQ(part.response().size(), static_cast<std::size_t>(end - first));
    for (int u = first; u < end; ++u) {
      const auto place = static_cast<std::size_t>(u - first), at = static_cast<std::size_t>(u);
      EXPECT_EQ(part.response()[place], whole.response()[at]) << u << " of " << first << " to " << end;
      EXPECT_EQ(part.Smoothed(place), whole.Smoothed(at));
    }
  }
}

TEST(RidgeResponse, PeaksAreWhereItFallsToBothSides) {
  const cv::Mat1b green = Noise(203, 5);
  RidgeResponse response(kKernel);
  response.Compute(green, 2, 0, green.cols);
  const std::vector<std::int16_t>& r = response.response();
  const std::int16_t least = 20 * RidgeKernel::kRowUnit;
  std::vector<int> expected;
  for (std::size_t u = 1; u + 1 < r.size(); ++u) {
    if (r[u] >= least && r[u] > r[u - 1] && r[u] >= r[u + 1]) expected.push_back(static_cast<int>(u));
  }
  EXPECT_GT(expected.size(), 10U);
  EXPECT_EQ(response.Peaks(least), expected);
  EXPECT_TRUE(response.Peaks(32767).empty());
}

TEST(RidgeResponse, ItsNoiseIsWhatTheGainSays) {
  const cv::Mat1b green = Noise(4000, 5);
  RidgeResponse response(kKernel);
  response.Compute(green, 2, 0, green.cols);
  double mean = 0.0, square = 0.0;
  for (const std::int16_t r : response.response()) {
    const double grey = static_cast<double>(RidgeResponse::kUnit) * r;
    mean += grey / 4000.0;
    square += grey * grey / 4000.0;
  }
  EXPECT_NEAR((square - mean * mean) / (255.0 * 255.0 / 12.0) / kKernel.NoiseGain(), 1.0, 0.1);
}

}  // namespace
}  // namespace dorsum
