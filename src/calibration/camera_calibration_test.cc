// SPDX-License-Identifier: Apache-2.0
#include "calibration/camera_calibration.h"

#include <atomic>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/temp_folder_test.h"
#include "calibration/board_view_test.h"
#include "captures/names.h"

namespace dorsum {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const cv::Size kInner(7, 5);
constexpr double kSquare = 20.0;
constexpr double kHeight = 400.0;

Camera TrueCamera() {
  Camera camera;
  camera.width = 480;
  camera.height = 360;
  camera.fx = camera.fy = 700.0;
  camera.cx = 235.0;
  camera.cy = 183.0;
  return camera;
}

class CameraCalibrationTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (int view = 0; view < kChessViews; ++view) {
      images_.push_back(
          DrawBoard({480, 360}, kInner, kSquare, BoardHomography(TrueCamera(), TiltedBoard(view, kHeight))));
    }
  }
  static void TearDownTestSuite() { images_.clear(); }

  CameraCalibrationTest() {
    series_.dir = folder_.path();
    series_.setup.board_columns = kInner.width;
    series_.setup.board_rows = kInner.height;
    series_.setup.square_mm = kSquare;
    series_.setup.width = 480;
    series_.setup.height = 360;
    for (int view = 0; view < kChessViews; ++view) {
      Write(view, images_[static_cast<std::size_t>(view)]);
      series_.chess_views.push_back(ChessName(view));
    }
  }
  void Write(int view, const cv::Mat& image) {
    cv::imwrite((folder_ / (ChessName(view) + ".png")).string(), image);
  }
  void Empty(int view) { Write(view, cv::Mat(360, 480, CV_8UC3, cv::Scalar::all(180))); }

  static std::vector<cv::Mat> images_;
  TempFolder folder_;
  CalibrationSeries series_;
};

std::vector<cv::Mat> CameraCalibrationTest::images_;

TEST_F(CameraCalibrationTest, TheCameraAndItsPlaceAboveTheFirstBoardComeBack) {
  const auto result = CalibrateCamera(series_, {}, {});
  ASSERT_TRUE(result.ok()) << result.error().message;
  const Camera& camera = result->camera;
  EXPECT_NEAR(camera.fx, 700.0, 3.0);
  EXPECT_NEAR(camera.fy, 700.0, 3.0);
  EXPECT_NEAR(camera.cx, 235.0, 3.0);
  EXPECT_NEAR(camera.cy, 183.0, 3.0);
  EXPECT_EQ(result->views.size(), 12U);
  EXPECT_EQ(result->view_rms_px.size(), 12U);
  EXPECT_EQ(result->report.grade, Grade::kGood);
  EXPECT_TRUE(result->warnings.empty());
  // World: origin at the first board's centre, x along its rows, z towards the camera.
  EXPECT_NEAR(camera.Center().z(), kHeight, 2.5);
  EXPECT_NEAR(camera.Center().x(), -6.0, 2.0);
  EXPECT_NEAR(camera.Center().y(), 0.0, 2.0);
  const Eigen::Vector2d origin = Project(camera, Eigen::Vector3d::Zero());
  const Eigen::Vector2d right = Project(camera, {40.0, 0.0, 0.0}), up = Project(camera, {0.0, 40.0, 0.0});
  EXPECT_NEAR(origin.x(), 235.0 + 700.0 * 6.0 / kHeight, 0.1);
  EXPECT_NEAR(right.x() - origin.x(), 70.0, 0.2);
  EXPECT_NEAR(up.y() - origin.y(), -70.0, 0.2);
}

TEST_F(CameraCalibrationTest, AViewWithoutABoardIsAWarning) {
  Empty(5);
  const auto result = CalibrateCamera(series_, {}, {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->views.size(), 11U);
  EXPECT_THAT(result->warnings, ElementsAre(HasSubstr("chess05")));
  EXPECT_NEAR(result->camera.fx, 700.0, 3.0);
}

TEST_F(CameraCalibrationTest, TooFewBoardsAreAnError) {
  for (int view = 3; view < 12; ++view) Empty(view);
  const auto result = CalibrateCamera(series_, {}, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_THAT(result.error().message, HasSubstr("only 3 of 12"));
}

TEST_F(CameraCalibrationTest, TheFirstViewFixesTheWorldAndMustShowABoard) {
  Empty(0);
  const auto result = CalibrateCamera(series_, {}, {});
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(result.error().message, HasSubstr("chess00"));
}

TEST_F(CameraCalibrationTest, ADamagedViewIsAnErrorNotAMissingBoard) {
  std::filesystem::resize_file(folder_ / "chess04.png", 2000);
  const auto result = CalibrateCamera(series_, {}, {});
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(result.error().message, HasSubstr("chess04"));
}

TEST_F(CameraCalibrationTest, CancellingStopsIt) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const auto result = CalibrateCamera(series_, {}, context);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
}

TEST(MoveWorld, ThePictureOfAPlaceStays) {
  Camera camera = TrueCamera();
  camera.camera_from_world.rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  camera.camera_from_world.translation = {3.0, -2.0, kHeight};
  const Eigen::Vector3d origin(10.0, -5.0, 0.0);
  const double angle = 0.3;
  const Camera moved = MoveWorld(camera, origin, angle);
  EXPECT_LT((Project(moved, Eigen::Vector3d::Zero()) - Project(camera, origin)).norm(), 1e-9);
  const Eigen::Vector3d new_x = origin + Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
  EXPECT_LT((Project(moved, Eigen::Vector3d::UnitX()) - Project(camera, new_x)).norm(), 1e-9);
  EXPECT_NEAR(moved.Center().z(), camera.Center().z(), 1e-9);
}

}  // namespace
}  // namespace dorsum
