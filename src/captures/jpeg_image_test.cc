// SPDX-License-Identifier: Apache-2.0
#include "captures/jpeg_image.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "captures/green_channel.h"

namespace dorsum {
namespace {

const cv::Size kSize(256, 192);

cv::Mat Picture() {
  cv::Mat image(kSize, CV_8UC3);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const int stripe = u % 9 < 2 ? 200 : 20;
      image.at<cv::Vec3b>(v, u) =
          cv::Vec3b(static_cast<unsigned char>(v), static_cast<unsigned char>(stripe + v % 7 * 5),
                    static_cast<unsigned char>(u));
    }
  }
  return image;
}

std::string Encode(const std::vector<int>& settings = {}) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", Picture(), bytes, settings);
  return {bytes.begin(), bytes.end()};
}

// Where the compressed data begins: behind the header of the first scan.
std::size_t ScanOf(const std::string& jpeg) { return jpeg.find("\xff\xda") + 14; }

// Decodes and expects that libjpeg keeps quiet.
cv::Mat DecodeQuietly(const std::string& jpeg) {
  ::testing::internal::CaptureStderr();
  cv::Mat image = DecodeJpeg(jpeg, kSize);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  return image;
}

TEST(JpegImage, HasTheValuesOfOpenCv) {
  for (const std::vector<int>& settings :
       {std::vector<int>{}, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}, {cv::IMWRITE_JPEG_RST_INTERVAL, 2}}) {
    const std::string jpeg = Encode(settings);
    const cv::Mat image = DecodeQuietly(jpeg);
    const cv::Mat expected = cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
    ASSERT_EQ(image.size(), expected.size());
    EXPECT_EQ(cv::norm(image, expected, cv::NORM_INF), 0.0);
    const cv::Mat green = DecodeJpeg(jpeg, kSize, Channels::kGreen);
    ASSERT_EQ(green.type(), CV_8UC1);
    EXPECT_EQ(cv::norm(green, GreenChannel(expected), cv::NORM_INF), 0.0);
  }
}

TEST(JpegImage, DamageInItsMiddleIsSeen) {
  const std::string whole = Encode();
  const std::size_t begin = ScanOf(whole), middle = (begin + whole.size()) / 2;
  ASSERT_LT(middle + 600, whole.size());
  std::string zeros = whole, ones = whole, cut = whole, marker = whole;
  zeros.replace(middle, 500, 500, '\0');
  ones.replace(middle, 500, 500, '\xff');
  cut.erase(middle, 500);
  marker.replace(middle, 2, "\xff\xd9");
  for (const std::string& damaged : {zeros, ones, cut, marker}) EXPECT_TRUE(DecodeQuietly(damaged).empty());
}

TEST(JpegImage, ALostRestartIntervalIsSeen) {
  std::string jpeg = Encode({cv::IMWRITE_JPEG_RST_INTERVAL, 2});
  const std::size_t first = jpeg.find("\xff\xd1", ScanOf(jpeg)), next = jpeg.find("\xff\xd2", first);
  ASSERT_NE(next, std::string::npos);
  jpeg.erase(first, next - first);
  EXPECT_TRUE(DecodeQuietly(jpeg).empty());
}

TEST(JpegImage, AWebcamsPaddingBeforeTheEndPasses) {
  const std::string whole = Encode();
  std::string padded = whole, stuffed = whole;
  padded.insert(whole.size() - 2, std::string(kJpegPadding, '\0'));
  stuffed.insert(whole.size() - 2, std::string(kJpegPadding + 20, '\0'));
  const cv::Mat image = DecodeQuietly(padded);
  ASSERT_FALSE(image.empty());
  EXPECT_EQ(cv::norm(image, DecodeQuietly(whole), cv::NORM_INF), 0.0);
  EXPECT_TRUE(DecodeQuietly(stuffed).empty());
}

TEST(JpegImage, NoBeginningOfAFileIsTakenForTheWhole) {
  const std::string whole = Encode();
  for (std::size_t n = 0; n + 2 < whole.size(); n += 17) {
    EXPECT_TRUE(DecodeQuietly(whole.substr(0, n)).empty()) << "cut at " << n;
  }
  EXPECT_TRUE(DecodeJpeg(whole, {256, 191}).empty());
}

TEST(JpegImageTest, WritesTheBytesThatOpenCvWrites) {
  EXPECT_EQ(EncodeJpeg(Picture(), 83), Encode({cv::IMWRITE_JPEG_QUALITY, 83}));
  EXPECT_EQ(EncodeJpeg(Picture(), 86, true),
            Encode({cv::IMWRITE_JPEG_QUALITY, 86, cv::IMWRITE_JPEG_OPTIMIZE, 1}));
  const cv::Mat part = Picture()(cv::Rect(3, 5, 101, 77));
  EXPECT_EQ(DecodeJpeg(EncodeJpeg(part, 95), part.size()).size(), part.size());
}

TEST(JpegImageTest, AFloatPictureIsAContractBroken) {
  EXPECT_THROW(EncodeJpeg(cv::Mat(2, 2, CV_32FC1), 90), std::logic_error);
  EXPECT_THROW(EncodeJpeg(cv::Mat(), 90), std::logic_error);
}

}  // namespace
}  // namespace dorsum
