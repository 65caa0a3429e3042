// SPDX-License-Identifier: Apache-2.0
#include "calibration/line_finder.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

constexpr int kRows = 201, kColumns = 400;

class LineFinderTest : public ::testing::Test {
 protected:
  void Draw(double at, double slope, int from = 0, int to = kRows - 1, int width = 3) {
    const auto x = [&](int row) { return static_cast<int>(std::lround(at + slope * (row - 100))); };
    cv::line(mask_, {x(from), from}, {x(to), to}, 255, width);
  }
  cv::Mat mask_ = cv::Mat::zeros(kRows, kColumns, CV_8UC1);
};

TEST_F(LineFinderTest, UprightAndTiltedLinesAreFoundOnceEach) {
  Draw(60, 0.0);
  Draw(150, 0.1);
  Draw(260, -0.2);
  const auto lines = FindVerticalLines(mask_, {}, {});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(lines[0].at, 60.0, 1.0);
  EXPECT_NEAR(lines[1].at, 150.0, 1.0);
  EXPECT_NEAR(lines[2].at, 260.0, 1.0);
  // A piece of a line as thick as these may turn by its thickness over its length.
  EXPECT_NEAR(lines[0].slope, 0.0, 0.03);
  EXPECT_NEAR(lines[1].slope, 0.1, 0.03);
  EXPECT_NEAR(lines[2].slope, -0.2, 0.03);
}

TEST_F(LineFinderTest, ABrokenLineIsOne) {
  Draw(80, 0.05, 0, 70);
  Draw(80, 0.05, 78, 130);
  Draw(80, 0.05, 139, 200);
  const auto lines = FindVerticalLines(mask_, {}, {});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].at, 80.0, 1.0);
  EXPECT_NEAR(lines[0].slope, 0.05, 0.03);
}

TEST_F(LineFinderTest, ShortLevelAndTooTiltedLinesAreNone) {
  Draw(80, 0.0, 20, 60);
  cv::line(mask_, {120, 20}, {390, 30}, 255, 2);
  Draw(250, 0.6, 20, 190);
  EXPECT_TRUE(FindVerticalLines(mask_, {}, {}).empty());
  EXPECT_TRUE(FindVerticalLines(cv::Mat::zeros(50, 50, CV_8UC1), {}, {}).empty());
}

TEST_F(LineFinderTest, BrightnessIsTheCrestsAlongTheLine) {
  Draw(60, 0.0);
  Draw(150, 0.1);
  cv::Mat intensity(kRows, kColumns, CV_8UC1, cv::Scalar(10));
  intensity.col(58).setTo(90);
  for (int r = 0; r < kRows; ++r)
    intensity.at<std::uint8_t>(r, static_cast<int>(std::lround(150 + 0.1 * (r - 100)))) = 200;
  const auto lines = FindVerticalLines(mask_, intensity, {});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lines[0].brightness, 90.0, 1e-9);
  EXPECT_NEAR(lines[1].brightness, 200.0, 1e-9);
}

}  // namespace
}  // namespace dorsum
