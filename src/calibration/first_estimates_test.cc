// SPDX-License-Identifier: Apache-2.0
#include "calibration/first_estimates.h"

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/temp_folder_test.h"
#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

TEST(AssignFirstEstimates, LasersRunInEitherDirection) {
  const std::vector<double> lines = {-90.0, -30.0, 30.0, 90.0};
  EXPECT_EQ(AssignFirstEstimates(lines, {{0, -85.0}, {1, -33.0}, {2, 28.0}, {3, 95.0}}),
            (std::map<int, double>{{0, -90.0}, {1, -30.0}, {2, 30.0}, {3, 90.0}}));
  EXPECT_EQ(AssignFirstEstimates(lines, {{0, 85.0}, {1, 33.0}, {2, -28.0}, {3, -95.0}}),
            (std::map<int, double>{{0, 90.0}, {1, 30.0}, {2, -30.0}, {3, -90.0}}));
}

TEST(AssignFirstEstimates, OneWrongBrightestStripeDoesNotTurnThemAround) {
  const std::vector<double> lines = {-90.0, -30.0, 30.0, 90.0};
  const auto assigned = AssignFirstEstimates(lines, {{0, 10.0}, {1, -30.0}, {2, 30.0}, {5, 90.0}});
  EXPECT_EQ(assigned.at(0), -90.0);
  EXPECT_EQ(assigned.at(5), 90.0);
}

// Mounted 2 degrees askew, a laser's central stripe lies 14 mm further on, beyond its neighbour's.
TEST(AssignFirstEstimates, LasersMayCross) {
  const std::map<int, double> brightest = {{0, 9.9}, {1, 0.1}, {2, 20.3}, {3, 29.8}};
  EXPECT_EQ(AssignFirstEstimates({0.0, 10.0, 20.0, 30.0}, brightest),
            (std::map<int, double>{{0, 10.0}, {1, 0.0}, {2, 20.0}, {3, 30.0}}));
}

TEST(AssignFirstEstimates, OtherCountsGiveNothing) {
  EXPECT_TRUE(AssignFirstEstimates({1.0, 2.0}, {{0, 1.0}}).empty());
  EXPECT_TRUE(AssignFirstEstimates({}, {{0, 1.0}}).empty());
  EXPECT_TRUE(AssignFirstEstimates({}, {}).empty());
}

class FirstEstimatesTest : public ::testing::Test {
 protected:
  FirstEstimatesTest() {
    series_.dir = folder_.path();
    series_.setup.width = camera_.width;
    series_.setup.height = camera_.height;
    Write("bgNoHand", {});
  }
  // A bright plane with dark lines at these places, world x in mm.
  void Write(const std::string& name, const std::vector<double>& lines) {
    cv::Mat image(camera_.height, camera_.width, CV_8UC3, cv::Scalar(150, 160, 150));
    for (const double x : lines) {
      const auto top = Project(camera_, {x + 3.0, 100.0, 0.0}),
                 bottom = Project(camera_, {x - 3.0, -100.0, 0.0});
      cv::line(image, {cvRound(top.x()), cvRound(top.y())}, {cvRound(bottom.x()), cvRound(bottom.y())},
               {40, 40, 40}, 3, cv::LINE_AA);
    }
    cv::imwrite((folder_ / (name + ".png")).string(), image);
  }
  Camera camera_ = TestCamera();
  TempFolder folder_;
  CalibrationSeries series_;
};

TEST_F(FirstEstimatesTest, DrawnLinesAreFoundInMillimetres) {
  Write("laserFirstEstimates", {-90.0, -30.0, 30.0, 90.0});
  const auto drawn = FindDrawnLines(series_, {}, {});
  ASSERT_TRUE(drawn.ok()) << drawn.error().message;
  const std::vector<double> xs = PlacesOfLines(*drawn, camera_);
  ASSERT_EQ(xs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(xs[i], -90.0 + 60.0 * static_cast<double>(i), 1.0);
}

TEST_F(FirstEstimatesTest, NoLinesAreNamed) {
  Write("laserFirstEstimates", {});
  const auto drawn = FindDrawnLines(series_, {}, {});
  ASSERT_FALSE(drawn.ok());
  EXPECT_THAT(drawn.error().message, HasSubstr("laserFirstEstimates"));
}

}  // namespace
}  // namespace dorsum
