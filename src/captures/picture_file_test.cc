// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_file.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/temp_folder_test.h"
#include "captures/image_file.h"

namespace dorsum {
namespace {

cv::Mat Ramp() {
  cv::Mat picture(64, 80, CV_8UC3);
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      picture.at<cv::Vec3b>(v, u) = cv::Vec3b::all(static_cast<std::uint8_t>(3 * u + (u * v) % 7));
    }
  }
  return picture;
}

TEST(PictureFile, APngHoldsTheSamePixels) {
  const TempFolder folder;
  CameraDesign camera;
  camera.format = "png";
  ASSERT_TRUE(WritePictureFile(camera, Ramp(), folder.path() / "bgHand").ok());
  const auto back = ReadImage(folder.path() / "bgHand.png");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(cv::norm(*back, Ramp(), cv::NORM_INF), 0.0);
}

TEST(PictureFile, AJpegIsWrittenUnderItsOwnExtension) {
  const TempFolder folder;
  ASSERT_TRUE(WritePictureFile(CameraDesign{}, Ramp(), folder.path() / "bgHand").ok());
  EXPECT_TRUE(ReadImage(folder.path() / "bgHand.jpg").ok());
}

TEST(PictureFile, NowhereToWriteIsBadInput) {
  const Status status = WritePictureFile(CameraDesign{}, Ramp(), "/proc/nowhere/bgHand");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
}

TEST(PictureFile, AStreamOfLowQualityChangesThePicture) {
  CameraDesign camera;
  EXPECT_EQ(cv::norm(*ThroughStream(camera, Ramp()), Ramp(), cv::NORM_INF), 0.0);
  camera.stream_jpeg_quality = 30;
  EXPECT_GT(cv::norm(*ThroughStream(camera, Ramp()), Ramp(), cv::NORM_INF), 2.0);
}

}  // namespace
}  // namespace dorsum
