// SPDX-License-Identifier: Apache-2.0
#include "simulator/sensor.h"

#include <cmath>
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

#include "captures/image_file.h"
#include "simulator/small_device_test.h"
#include "simulator/truth_files.h"

namespace dorsum {
namespace {

SensorDesign Noiseless(bool bayer) {
  SensorDesign sensor;
  sensor.full_well_e = 0.0;
  sensor.bayer = bayer;
  return sensor;
}

// One bright column on a dark field.
cv::Mat ThinLine(int column) {
  cv::Mat light(24, 32, CV_32F, cv::Scalar(0.1));
  light.col(column).setTo(0.8);
  return light;
}

TEST(Sensor, AMosaicOfEvenLightLooksLikeFullColour) {
  const cv::Mat light(20, 30, CV_32F, cv::Scalar(0.5));
  const cv::Mat full = Digitise(Noiseless(false), light, 1, Context{});
  const cv::Mat mosaic = Digitise(Noiseless(true), light, 1, Context{});
  for (int c = 0; c < 3; ++c) {
    const int expected = full.at<cv::Vec3b>(0, 0)[c];
    for (int v = 0; v < light.rows; ++v) {
      for (int u = 0; u < light.cols; ++u) EXPECT_NEAR(mosaic.at<cv::Vec3b>(v, u)[c], expected, 1) << u << v;
    }
  }
}

TEST(Sensor, AMosaicSeesAThinLineInEverySecondRowOnly) {
  // On the line, green pixels (of RG above GB: odd row on an even column) see it, the others interpolate:
  // half of it from the line's own column, half from the dark to its left and right.
  constexpr int kColumn = 16;
  const cv::Mat picture = Digitise(Noiseless(true), ThinLine(kColumn), 1, Context{});
  for (int v = 4; v < 20; ++v) {
    const double share = v % 2 == 1 ? 0.8 : 0.5 * (0.8 + 0.1);
    EXPECT_NEAR(picture.at<cv::Vec3b>(v, kColumn)[1], 255.0 * share, 1.0) << v;
    EXPECT_GE(picture.at<cv::Vec3b>(v, kColumn)[1], 4 * picture.at<cv::Vec3b>(v, kColumn)[2]) << v;
  }
}

TEST(Sensor, InterpolatesBeforeGamma) {
  SensorDesign sensor = Noiseless(true);
  sensor.gamma = 2.2;
  const cv::Mat picture = Digitise(sensor, ThinLine(16), 1, Context{});
  EXPECT_NEAR(picture.at<cv::Vec3b>(10, 16)[1], 255.0 * std::pow(0.45, 1.0 / 2.2), 1.0);
}

TEST(Sensor, NoiseIsTheSameAtAnyNumberOfThreads) {
  SensorDesign sensor;
  sensor.bayer = true;
  Context one, two;
  one.threads = 1;
  two.threads = 2;
  const cv::Mat a = Digitise(sensor, ThinLine(9), 5, one), b = Digitise(sensor, ThinLine(9), 5, two),
                c = Digitise(sensor, ThinLine(9), 6, two);
  EXPECT_EQ(std::memcmp(a.data, b.data, a.total() * 3), 0);
  EXPECT_NE(std::memcmp(a.data, c.data, a.total() * 3), 0);
}

TEST(Sensor, AWebcamsStreamLeavesItsBlocksInTheFile) {
  const auto dir = std::filesystem::path(::testing::TempDir());
  const cv::Mat picture = Digitise(SensorDesign{}, ThinLine(11), 1, Context{});
  CameraDesign camera;
  camera.format = "png";
  const auto written = [&](const char* name) {
    EXPECT_TRUE(WritePicture(camera, picture, dir / name).ok());
    auto image = ReadImage(dir / (std::string(name) + ".png"));
    EXPECT_TRUE(image.ok());
    std::filesystem::remove(dir / (std::string(name) + ".png"));
    return image.ok() ? *image : cv::Mat(picture.size(), CV_8UC3);
  };
  EXPECT_EQ(cv::norm(written("sensor_plain"), picture, cv::NORM_INF), 0.0);
  camera.stream_jpeg_quality = 60;
  const double error = cv::norm(written("sensor_stream"), picture, cv::NORM_INF);
  EXPECT_GT(error, 2.0);
  EXPECT_LT(error, 80.0);
}

}  // namespace
}  // namespace dorsum
