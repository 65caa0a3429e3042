// SPDX-License-Identifier: Apache-2.0
#include "captures/image_file.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "captures/green_channel.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string Encode(const std::string& extension, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(extension, image, bytes);
  return {bytes.begin(), bytes.end()};
}

cv::Mat Noise(int rows, int columns, int type) {
  cv::Mat image(rows, columns, type);
  cv::randu(image, 0, 255);
  return image;
}

std::string MessageOf(const Result<cv::Mat>& result) {
  if (result.ok()) return "(no error)";
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  return result.error().message;
}

TEST(ImageFile, ReadsColourPngAndJpegAsTheyAre) {
  const TempFolder folder;
  const cv::Mat image = Noise(20, 30, CV_8UC3);
  ASSERT_TRUE(WriteFile(folder / "a.png", Encode(".png", image)).ok());
  const auto png = ReadImage(folder / "a.png", cv::Size(30, 20));
  ASSERT_TRUE(png.ok());
  EXPECT_EQ(cv::norm(*png, image, cv::NORM_INF), 0.0);
  const auto jpeg = DecodeImage(Encode(".jpg", cv::Mat(20, 30, CV_8UC3, cv::Scalar(10, 120, 240))), "a");
  ASSERT_TRUE(jpeg.ok());
  EXPECT_NEAR(GreenChannel(*jpeg).at<std::uint8_t>(5, 5), 120, 4);
}

TEST(ImageFile, AnOrientationTagDoesNotTurnTheImage) {
  // The calibration knows pixels as they lie on the sensor.
  std::string jpeg = Encode(".jpg", Noise(16, 32, CV_8UC3));
  const std::string exif(
      "\xff\xe1\x00\x22"
      "Exif\0\0"
      "II*\0\x08\0\0\0"
      "\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0"  // orientation 6: a quarter turn
      "\0\0\0\0",
      36);
  jpeg.insert(2, exif);
  const auto image = DecodeImage(jpeg, "a", cv::Size(32, 16));
  ASSERT_TRUE(image.ok()) << image.error().message;
  EXPECT_EQ(image->size(), cv::Size(32, 16));
}

TEST(ImageFile, EachUnusableImageIsNamedWithItsReason) {
  const cv::Mat colour = Noise(20, 30, CV_8UC3);
  const std::string jpeg = Encode(".jpg", colour);
  EXPECT_THAT(MessageOf(DecodeImage(jpeg.substr(0, jpeg.size() / 2), "a.jpg")),
              AllOf(HasSubstr("a.jpg"), HasSubstr("cut off")));
  EXPECT_THAT(MessageOf(DecodeImage(Encode(".png", Noise(20, 30, CV_8UC1)), "a.png")),
              AllOf(HasSubstr("a.png"), HasSubstr("grey")));
  EXPECT_THAT(MessageOf(DecodeImage(Encode(".png", Noise(20, 30, CV_16UC3)), "a.png")), HasSubstr("16 bits"));
  EXPECT_THAT(MessageOf(DecodeImage(Encode(".png", Noise(20, 30, CV_8UC4)), "a.png")),
              HasSubstr("plain colour"));
  EXPECT_THAT(MessageOf(DecodeImage(jpeg, "a.jpg", cv::Size(31, 20))),
              AllOf(HasSubstr("30x20"), HasSubstr("31x20")));
  EXPECT_THAT(MessageOf(DecodeImage("no image", "a.png")), AllOf(HasSubstr("a.png"), HasSubstr("neither")));
  EXPECT_THAT(MessageOf(DecodeImage("", "a.png")), HasSubstr("a.png is empty"));
}

TEST(ImageFile, AHugeImageIsRefusedBeforeItIsDecoded) {
  std::string png = Encode(".png", Noise(8, 8, CV_8UC3));
  png.replace(16, 8, std::string("\0\0\x4e\x20\0\0\x4e\x20", 8));  // 20000 x 20000
  EXPECT_THAT(MessageOf(DecodeImage(png, "a.png")),
              AllOf(HasSubstr("20000x20000"), HasSubstr("more than any camera")));
}

TEST(ImageFile, DamageInsideIsAnErrorNotAnException) {
  std::string png = Encode(".png", Noise(20, 30, CV_8UC3));
  for (std::size_t i = 45; i < 80; ++i) png[i] = '\0';
  EXPECT_THAT(MessageOf(DecodeImage(png, "a.png")), HasSubstr("a.png"));
  std::string header = Encode(".png", Noise(20, 30, CV_8UC3));
  header[19] = 31;  // the width disagrees with the data and the checksum
  EXPECT_FALSE(DecodeImage(header, "a.png").ok());
  std::string jpeg = Encode(".jpg", Noise(20, 30, CV_8UC3));
  jpeg.replace(jpeg.size() / 2 + 200, 40, 40, '\0');
  EXPECT_THAT(MessageOf(DecodeImage(jpeg, "a.jpg")), AllOf(HasSubstr("a.jpg"), HasSubstr("damaged")));
}

TEST(ImageFile, AFolderAndAMissingFileAreNoImages) {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "a.png");
  EXPECT_THAT(MessageOf(ReadImage(folder / "a.png")), HasSubstr("is not a file"));
  EXPECT_FALSE(FindImage(folder.path(), "a").has_value());
  EXPECT_THAT(RequireImage(folder.path(), "a").error().message,
              AllOf(HasSubstr("the image a"), HasSubstr("missing")));
  EXPECT_FALSE(ReadImage(folder / "none.png").ok());
}

TEST(ImageFile, FindsEachUsualExtension) {
  const TempFolder folder;
  for (const char* name : {"a.png", "b.jpg", "c.jpeg", "d.JPG"})
    ASSERT_TRUE(WriteFile(folder / name, "x").ok());
  ASSERT_TRUE(WriteFile(folder / "e.tif", "x").ok());
  for (const char* name : {"a", "b", "c", "d"})
    EXPECT_TRUE(FindImage(folder.path(), name).has_value()) << name;
  EXPECT_FALSE(FindImage(folder.path(), "e").has_value());
}

}  // namespace
}  // namespace dorsum
