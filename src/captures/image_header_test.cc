// SPDX-License-Identifier: Apache-2.0
#include "captures/image_header.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace dorsum {
namespace {

std::string Encode(const std::string& extension, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(extension, image, bytes);
  return {bytes.begin(), bytes.end()};
}

TEST(ImageHeader, SaysWhatAnEncoderWrote) {
  struct Case {
    const char* extension;
    int type, bits, channels;
  };
  for (const Case& c : {Case{".png", CV_8UC3, 8, 3}, Case{".png", CV_8UC1, 8, 1}, Case{".png", CV_8UC4, 8, 4},
                        Case{".png", CV_16UC3, 16, 3}, Case{".png", CV_16UC1, 16, 1},
                        Case{".jpg", CV_8UC3, 8, 3}, Case{".jpg", CV_8UC1, 8, 1}}) {
    const auto header = ReadImageHeader(Encode(c.extension, cv::Mat::ones(31, 47, c.type)));
    ASSERT_TRUE(header.ok());
    EXPECT_EQ(header->format, std::string(c.extension) == ".png" ? "PNG" : "JPEG");
    EXPECT_EQ(header->width, 47);
    EXPECT_EQ(header->height, 31);
    EXPECT_EQ(header->bits, c.bits);
    EXPECT_EQ(header->channels, c.channels);
    EXPECT_TRUE(header->complete);
  }
}

TEST(ImageHeader, AMissingEndIsSeen) {
  cv::Mat image(40, 50, CV_8UC3);
  cv::randu(image, 0, 255);
  for (const char* extension : {".png", ".jpg"}) {
    const std::string bytes = Encode(extension, image);
    const auto header = ReadImageHeader(std::string_view(bytes).substr(0, bytes.size() / 2));
    ASSERT_TRUE(header.ok());
    EXPECT_EQ(header->width, 50);
    EXPECT_FALSE(header->complete) << extension;
  }
}

TEST(ImageHeader, PaddingAfterTheEndIsAllowed) {
  for (const char* extension : {".png", ".jpg"}) {
    const auto header =
        ReadImageHeader(Encode(extension, cv::Mat::ones(8, 8, CV_8UC3)) + std::string(64, '\0'));
    ASSERT_TRUE(header.ok());
    EXPECT_TRUE(header->complete) << extension;
  }
}

TEST(ImageHeader, WhatIsNoImageIsRefused) {
  EXPECT_EQ(ReadImageHeader("").error().message, "is empty");
  for (const std::string& bytes :
       {std::string("garbage that is no image at all"), std::string("\x89PNG"), std::string(100, '\0'),
        std::string("\x89PNG\r\n\x1a\n"), std::string("\xff\xd8"), std::string("\xff\xd8\xff\xe0"),
        std::string("\xff\xd8garbage instead of markers"), "\xff\xd8" + std::string(100, '\xff')}) {
    EXPECT_FALSE(ReadImageHeader(bytes).ok());
  }
}

TEST(ImageHeader, AnImageWithoutPixelsIsRefused) {
  std::string png = Encode(".png", cv::Mat::ones(8, 8, CV_8UC3));
  for (int i = 16; i < 20; ++i) png[static_cast<std::size_t>(i)] = '\0';
  EXPECT_FALSE(ReadImageHeader(png).ok());
  png[16] = '\xff';  // a negative width, read as signed
  EXPECT_FALSE(ReadImageHeader(png).ok());
}

TEST(ImageHeader, EveryBeginningIsReadWithoutGoingPastItsEnd) {
  for (const char* extension : {".png", ".jpg"}) {
    const std::string bytes = Encode(extension, cv::Mat::ones(8, 8, CV_8UC3));
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      const auto header = ReadImageHeader(std::string(bytes, 0, n));
      if (header.ok()) {
        EXPECT_EQ(header->width, 8);
        // The last bytes of a PNG are a checksum.
        EXPECT_TRUE(!header->complete || n + 8 >= bytes.size()) << extension << " cut at " << n;
      }
    }
  }
}

}  // namespace
}  // namespace dorsum
