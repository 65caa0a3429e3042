// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_metadata.h"

#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <zlib.h>

#include "captures/image_file.h"

namespace dorsum {
namespace {

std::string Encoded(const std::string& extension, const std::vector<int>& parameters = {}) {
  cv::Mat picture(48, 64, CV_8UC3);
  cv::randu(picture, 0, 256);
  std::vector<unsigned char> bytes;
  cv::imencode(extension, picture, bytes, parameters);
  return {bytes.begin(), bytes.end()};
}

std::string Big32(std::size_t n) {
  return {static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
          static_cast<char>(n)};
}

std::string Chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum = crc32_z(0, reinterpret_cast<const unsigned char*>(body.data()), body.size());
  return Big32(data.size()) + body + Big32(sum);
}

std::string Segment(char marker, const std::string& data) {
  const std::size_t n = data.size() + 2;
  return std::string("\xff") + marker + static_cast<char>(n >> 8) + static_cast<char>(n & 0xff) + data;
}

// The result has the same pixels, and no trace of the secret.
void ExpectPlain(const std::string& with, const std::string& secret) {
  const auto plain = WithoutMetadata(with);
  ASSERT_TRUE(plain.ok()) << plain.error().message;
  EXPECT_NE(with.find(secret), std::string::npos);
  EXPECT_EQ(plain->find(secret), std::string::npos);
  const auto before = DecodeImage(with, "before"), after = DecodeImage(*plain, "after");
  ASSERT_TRUE(before.ok() && after.ok());
  EXPECT_EQ(cv::norm(*before, *after, cv::NORM_INF), 0.0);
  EXPECT_EQ(*WithoutMetadata(*plain), *plain);
}

TEST(PictureMetadataTest, PngLosesTextTimePlaceAndWhatFollowsItsEnd) {
  const std::string png = Encoded(".png");
  for (const char* type : {"tEXt", "zTXt", "iTXt", "eXIf", "tIME", "pHYs", "prVt"}) {
    ExpectPlain(png.substr(0, 33) + Chunk(type, std::string("Author\0SECRET", 13)) + png.substr(33),
                "SECRET");
  }
  ExpectPlain(png + "SECRET", "SECRET");
}

TEST(PictureMetadataTest, JpegLosesExifCommentsProfilesAndPreviews) {
  for (const int progressive : {0, 1}) {
    const std::string jpeg = Encoded(".jpg", {cv::IMWRITE_JPEG_PROGRESSIVE, progressive,
                                              cv::IMWRITE_JPEG_RST_INTERVAL, progressive == 0 ? 4 : 0});
    const auto with = [&](const std::string& segment) {
      return jpeg.substr(0, 2) + segment + jpeg.substr(2);
    };
    ExpectPlain(with(Segment('\xe1', std::string("Exif\0\0SECRET", 12))), "SECRET");
    ExpectPlain(with(Segment('\xfe', "SECRET")), "SECRET");
    ExpectPlain(with(Segment('\xe2', "ICC_PROFILE SECRET")), "SECRET");
    ExpectPlain(with(Segment('\xe0', std::string("JFXX\0\x10SECRET", 12))), "SECRET");
    // A comment between the tables and the scan, and bytes behind the end.
    const std::size_t scan = jpeg.find("\xff\xda");
    ExpectPlain(jpeg.substr(0, scan) + Segment('\xfe', "SECRET") + jpeg.substr(scan), "SECRET");
    ExpectPlain(jpeg + "SECRET", "SECRET");
    // The fixed parts of JFIF and Adobe stay, what hangs on them goes.
    ExpectPlain(with(Segment('\xee', std::string("Adobe\0\x64\0\0\0\0\1SECRET", 18))), "SECRET");
  }
}

TEST(PictureMetadataTest, TornPicturesAreRefusedAtEveryLength) {
  for (const std::string& whole : {Encoded(".png"), Encoded(".jpg")}) {
    for (std::size_t n = 0; n < whole.size(); n += n < 1000 ? 1 : 97) {
      EXPECT_FALSE(WithoutMetadata(whole.substr(0, n)).ok()) << n;
    }
  }
  EXPECT_FALSE(WithoutMetadata("GIF89a").ok());
}

}  // namespace
}  // namespace dorsum
