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

const std::vector<float> kKernel = {0.5F, 0.25F, -0.125F, -0.375F};

TEST(RidgeResponse, IsTheKernelOverFiveSmoothedRows) {
  for (const int cols : {1, 5, 33, 100}) {
    const cv::Mat1b green = Noise(cols, 9);
    RidgeResponse response(kKernel);
    for (const int row : {0, 1, 4, 8}) {
      response.Compute(green, row, 0, cols);
      const auto smooth = [&](int u) {
        const int x = std::clamp(u, 0, cols - 1);
        float sum = 0.0F;
        for (const auto& [k, w] : {std::pair{-2, 1.0F}, {-1, 4.0F}, {0, 6.0F}, {1, 4.0F}, {2, 1.0F}})
          sum += w / 16.0F * static_cast<float>(green(std::clamp(row + k, 0, 8), x));
        return sum;
      };
      ASSERT_EQ(response.response().size(), static_cast<std::size_t>(cols));
      for (int u = 0; u < cols; ++u) {
        float expected = kKernel[0] * smooth(u);
        for (int k = 1; k < 4; ++k)
          expected += kKernel[static_cast<std::size_t>(k)] * (smooth(u - k) + smooth(u + k));
        EXPECT_NEAR(response.response()[static_cast<std::size_t>(u)], expected, 1e-3F) << u << " of " << cols;
        EXPECT_EQ(response.Smoothed(static_cast<std::size_t>(u)), smooth(u));
      }
    }
  }
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
  const std::vector<float>& r = response.response();
  std::vector<int> expected;
  for (std::size_t u = 1; u + 1 < r.size(); ++u) {
    if (r[u] >= 20.0F && r[u] > r[u - 1] && r[u] >= r[u + 1]) expected.push_back(static_cast<int>(u));
  }
  EXPECT_GT(expected.size(), 10U);
  EXPECT_EQ(response.Peaks(20.0F), expected);
  EXPECT_TRUE(response.Peaks(1e6F).empty());
}

TEST(RidgeResponse, ItsNoiseIsWhatTheGainSays) {
  const cv::Mat1b green = Noise(4000, 5);
  RidgeResponse response(kKernel);
  response.Compute(green, 2, 0, green.cols);
  double mean = 0.0, square = 0.0;
  for (const float r : response.response()) {
    mean += static_cast<double>(r) / 4000.0;
    square += static_cast<double>(r) * static_cast<double>(r) / 4000.0;
  }
  EXPECT_NEAR((square - mean * mean) / (255.0 * 255.0 / 12.0) / NoiseGain(kKernel), 1.0, 0.1);
}

}  // namespace
}  // namespace dorsum
