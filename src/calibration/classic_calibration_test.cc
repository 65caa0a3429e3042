// SPDX-License-Identifier: Apache-2.0
#include "calibration/classic_calibration.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/temp_folder_test.h"
#include "calibration/board_view_test.h"
#include "captures/names.h"
#include "geometry/plane_device_test.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kCentral = 15.0, kSpacing = 24.0, kLean = 0.03, kObject = 40.0, kSquare = 30.0;
const cv::Size kInner(7, 5);

// A whole calibration folder of laser 1 alone: its grating is 300 mm above x = 15, its stripes lie every 24
// mm and lean against the first board.
class ClassicCalibrationTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TempFolder;
    const Camera camera = TestCamera();
    for (int view = 0; view < kChessViews; ++view) {
      Rigid3 pose = TiltedBoard(view, kTestCameraHeight);
      if (view == 0) pose.translation.x() = 0.0;
      WriteBoard(ChessName(view), pose);
    }
    Rigid3 flat = TiltedBoard(0, kTestCameraHeight);
    WriteBoard("laser1CalFurtherChess", flat);
    flat.translation.z() -= kObject;
    WriteBoard("laser1CalCloserChess", flat);
    const cv::Mat dark(camera.height, camera.width, CV_8UC3, cv::Scalar(10, 12, 10));
    for (const char* name : {"laserCalFurtherBg", "laserCalCloserBg"}) Write(name, dark);
    Write("laser1CalFurther", DrawStripes(0.0));
    Write("stripesBg1", DrawStripes(0.0));
    Write("laser1CalCloser", DrawStripes(kObject));
    cv::Mat light(camera.height, camera.width, CV_8UC3, cv::Scalar(150, 160, 150));
    Write("bgNoHand", light);
    for (int v = 0; v < light.rows; ++v) {
      const int u = cvRound(320.0 + 2.0 * kCentral + kLean * (240 - v));
      light(cv::Rect(u - 1, v, 3, 1)).setTo(cv::Scalar(30, 30, 30));
    }
    Write("laserFirstEstimates", light);
    dorsum::Setup setup;
    setup.board_columns = kInner.width;
    setup.board_rows = kInner.height;
    setup.square_mm = kSquare;
    setup.calibration_object_height_mm = kObject;
    setup.grating_lines_per_mm = 100.0;
    setup.wavelength_nm = 532.0;
    setup.width = camera.width;
    setup.height = camera.height;
    ASSERT_TRUE(WriteJson(*folder_ / kSetupName, SetupToJson(setup)).ok());
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static void Write(const std::string& name, const cv::Mat& image) {
    ASSERT_TRUE(cv::imwrite((*folder_ / (name + ".png")).string(), image));
  }
  static void WriteBoard(const std::string& name, const Rigid3& pose) {
    Write(name, DrawBoard({640, 480}, kInner, kSquare, BoardHomography(TestCamera(), pose)));
  }
  // What the camera sees of the stripes on a plane of that height.
  static cv::Mat DrawStripes(double z) {
    const double px_per_mm = 800.0 / (kTestCameraHeight - z);
    cv::Mat image(480, 640, CV_8UC3, cv::Scalar(10, 12, 10));
    for (int v = 0; v < image.rows; ++v) {
      const double y = (240.0 - v) / px_per_mm;
      for (int u = 0; u < image.cols; ++u) {
        const double x = (u - 320.0) / px_per_mm;
        const double order = (x - kCentral - kLean * y) / (kSpacing * (1.0 - z / kTestGratingHeight));
        const double off_px = (order - std::round(order)) * kSpacing * 2.0;
        const double peak = std::round(order) == 0.0 ? 190.0 : 110.0;
        image.at<cv::Vec3b>(v, u)[1] =
            cv::saturate_cast<uchar>(12.0 + peak * std::exp(-0.5 * off_px * off_px / 6.25));
      }
    }
    return image;
  }
  static TempFolder* folder_;
};

TempFolder* ClassicCalibrationTest::folder_ = nullptr;

TEST_F(ClassicCalibrationTest, TheDeviceComesBackFromItsImages) {
  const auto series = LoadCalibrationSeries(folder_->path());
  ASSERT_TRUE(series.ok()) << series.error().message;
  const auto c = CalibrateClassic(*series, {}, {});
  ASSERT_TRUE(c.ok()) << c.error().message;
  EXPECT_THAT(c->warnings, IsEmpty());
  ASSERT_EQ(c->device.lasers.size(), 1U);
  const LaserGeometry& laser = c->device.lasers[0];
  EXPECT_EQ(laser.laser, 1);
  EXPECT_NEAR(c->device.camera.fx, 800.0, 4.0);
  EXPECT_NEAR(laser.grating.z(), kTestGratingHeight, 8.0);
  EXPECT_NEAR(laser.grating.x(), kCentral, 1.0);
  EXPECT_EQ(laser.grating.y(), 0.0);
  EXPECT_EQ(static_cast<int>(laser.planes.size()), laser.max_order - laser.min_order + 1);
  EXPECT_LE(laser.min_order, -6);
  EXPECT_GE(laser.max_order, 5);
  for (const PlaneSheet& sheet : laser.planes) {
    if (std::abs(sheet.order) > 5) continue;  // beyond the chessboards, where the lens is a guess
    EXPECT_NEAR(OnSheet(sheet, 0.0, 0.0).x(), kCentral + kSpacing * sheet.order, 1.5)
        << "order " << sheet.order;
  }
  EXPECT_EQ(laser.reference.size(), laser.planes.size());
  EXPECT_EQ(c->lasers[0].report.grade, Grade::kGood) << c->lasers[0].report.verdict;
}

TEST_F(ClassicCalibrationTest, TheWorldIsTurnedUntilLaserOnesCentralStripeRunsAlongY) {
  const auto c = CalibrateClassic(LoadCalibrationSeries(folder_->path()).value(), {}, {});
  ASSERT_TRUE(c.ok());
  const auto& lines = c->lasers[0].background.lines;
  const auto central = std::find_if(lines.begin(), lines.end(), [](const auto& l) { return l.order == 0; });
  ASSERT_NE(central, lines.end());
  EXPECT_NEAR(central->slope, 0.0, 0.002);
  // The stripe leans towards growing u at the image's top, and so does the new y axis.
  const Eigen::Vector2d top = Project(c->device.camera, {0.0, 100.0, 0.0}),
                        bottom = Project(c->device.camera, {0.0, -100.0, 0.0});
  EXPECT_NEAR((top.x() - bottom.x()) / (bottom.y() - top.y()), kLean, 0.003);
  EXPECT_LT((Project(c->device.camera, Eigen::Vector3d::Zero()) - Eigen::Vector2d(320.0, 240.0)).norm(), 0.3);
}

TEST_F(ClassicCalibrationTest, ADarkStripeImageIsNamed) {
  const auto series = LoadCalibrationSeries(folder_->path());
  ASSERT_TRUE(series.ok());
  const cv::Mat lit = cv::imread((*folder_ / "stripesBg1.png").string());
  Write("stripesBg1", cv::Mat(480, 640, CV_8UC3, cv::Scalar(10, 12, 10)));
  const auto c = CalibrateClassic(*series, {}, {});
  Write("stripesBg1", lit);
  ASSERT_FALSE(c.ok());
  EXPECT_EQ(c.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(c.error().message, HasSubstr("stripesBg1"));
}

}  // namespace
}  // namespace dorsum
