// SPDX-License-Identifier: Apache-2.0
#include "speed/steger.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dorsum::speed {
namespace {

TEST(Steger, FindsASlantedLineToATenthOfAPixel) {
  cv::Mat green(80, 90, CV_8UC1);
  const auto centre = [](double v) { return 40.3 + 0.1 * v; };
  for (int v = 0; v < green.rows; ++v) {
    for (int u = 0; u < green.cols; ++u) {
      const double t = (u - centre(v)) / 2.4;
      green.at<std::uint8_t>(v, u) =
          static_cast<std::uint8_t>(std::lround(10.0 + 150.0 * std::exp(-0.5 * t * t)));
    }
  }
  const auto points = DetectSteger(green, 2.4, 1.0);
  EXPECT_GT(points.size(), 70U);
  for (const cv::Point2f& p : points) {
    if (p.y < 8.0F || p.y > 71.0F) continue;
    EXPECT_NEAR(p.x, centre(p.y), 0.1);
  }
}

}  // namespace
}  // namespace dorsum::speed
