// SPDX-License-Identifier: Apache-2.0
#include "calibration/stripe_spacing.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/temp_folder_test.h"
#include "calibration/board_view_test.h"
#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

TEST(MeanSpacing, RunsFromTheFirstToTheLastStripeOfTheOrdersAskedFor) {
  PlaneStripes s;
  s.x_mm = {-21.0, -10.0, 0.0, 10.0, 20.0, 42.0};
  s.index = {0, 1, 2, 3, 4, 6};  // one missing before the last
  s.central = 2;
  EXPECT_NEAR(MeanSpacing(s, -2, 4), 63.0 / 6.0, 1e-12);
  EXPECT_NEAR(MeanSpacing(s, -1, 2), 10.0, 1e-12);
  EXPECT_NEAR(MeanSpacing(s, -2, 3), 41.0 / 4.0, 1e-12) << "order 3 is missing, so it ends at 2";
  EXPECT_EQ(MeanSpacing(s, 0, 0), 0.0);
  EXPECT_EQ(MeanSpacing(s, 7, 9), 0.0);
}

class ObserveStripesTest : public ::testing::Test {
 protected:
  ObserveStripesTest() {
    series_.dir = folder_.path();
    series_.setup.board_columns = 7;
    series_.setup.board_rows = 5;
    series_.setup.square_mm = 20.0;
    series_.setup.width = camera_.width;
    series_.setup.height = camera_.height;
    const double px_per_mm = camera_.fx / kTestCameraHeight;
    const cv::Matx33d above(px_per_mm, 0, camera_.cx, 0, px_per_mm, camera_.cy, 0, 0, 1);
    Write("laser0CalFurtherChess", DrawBoard({camera_.width, camera_.height}, {7, 5}, 20.0, above));
    Write("laserCalFurtherBg", cv::Mat(camera_.height, camera_.width, CV_8UC3, cv::Scalar(12, 15, 12)));
  }
  // Upright stripes at these places of the backplane, the central one twice as bright.
  void WriteStripes(const std::vector<double>& x_mm, double central_mm) {
    cv::Mat image(camera_.height, camera_.width, CV_8UC3, cv::Scalar(12, 15, 12));
    for (int u = 0; u < camera_.width; ++u) {
      double green = 15.0;
      for (const double x : x_mm) {
        const double at = camera_.cx + camera_.fx / kTestCameraHeight * x;
        green += (x == central_mm ? 200.0 : 100.0) * std::exp(-0.5 * std::pow((u - at) / 2.5, 2));
      }
      image.col(u).setTo(cv::Scalar(12, green, 12));
    }
    Write("laser0CalFurther", image);
  }
  void Write(const std::string& name, const cv::Mat& image) {
    cv::imwrite((folder_ / (name + ".png")).string(), image);
  }
  Result<PlaneStripes> Observe() { return ObserveStripes(series_, camera_, 0, Distance::kFurther, {}, {}); }

  Camera camera_ = TestCamera();
  TempFolder folder_;
  CalibrationSeries series_;
};

TEST_F(ObserveStripesTest, StripesAreMeasuredInMillimetresAndCountedOverAGap) {
  const std::vector<double> x = {-90.0, -60.0, -30.0, 0.0, 30.0, 90.0, 120.0};  // 60 is missing
  WriteStripes(x, 30.0);
  const auto seen = Observe();
  ASSERT_TRUE(seen.ok()) << seen.error().message;
  ASSERT_EQ(seen->x_mm.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(seen->x_mm[i] - seen->x_mm[0], x[i] - x[0], 0.5);
  // The lines run along the falling flanks, all to the same side of the crests.
  EXPECT_NEAR(seen->x_mm[0], x[0], 3.0);
  EXPECT_EQ(seen->index, (std::vector<int>{0, 1, 2, 3, 4, 6, 7}));
  EXPECT_EQ(seen->central, 4);
  EXPECT_NEAR(MeanSpacing(*seen, -4, 3), 30.0, 0.1);
  EXPECT_FALSE(seen->picture.empty());
}

TEST_F(ObserveStripesTest, ALaserThatIsOffIsNamed) {
  WriteStripes({}, 0.0);
  const auto seen = Observe();
  ASSERT_FALSE(seen.ok());
  EXPECT_THAT(seen.error().message, HasSubstr("laser0CalFurther"));
}

TEST_F(ObserveStripesTest, AMissingBoardIsNamed) {
  WriteStripes({-30.0, 0.0, 30.0, 60.0}, 0.0);
  Write("laser0CalFurtherChess", cv::Mat(camera_.height, camera_.width, CV_8UC3, cv::Scalar::all(100)));
  const auto seen = Observe();
  ASSERT_FALSE(seen.ok());
  EXPECT_THAT(seen.error().message, HasSubstr("laser0CalFurtherChess"));
}

}  // namespace
}  // namespace dorsum
