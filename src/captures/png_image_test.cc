// SPDX-License-Identifier: Apache-2.0
#include "captures/png_image.h"

#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/random.h"

namespace dorsum {
namespace {

cv::Mat Noise(int type) {
  Rng rng(5);
  cv::Mat out(21, 33, type);
  for (std::uint8_t* byte = out.data; byte != out.dataend; ++byte)
    *byte = static_cast<std::uint8_t>(255.0 * rng.Uniform());
  return out;
}

bool Same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

cv::Mat ByOpenCv(const std::string& bytes) {
  return cv::imdecode(std::vector<char>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
}

std::string FromOpenCv(const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

TEST(PngImageTest, EveryKindIsReadByOthersAsItWas) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC1, CV_16UC3}) {
    const cv::Mat image = Noise(type);
    for (const int compression : {0, 1, 3, 9})
      EXPECT_TRUE(Same(ByOpenCv(EncodePng(image, compression)), image));
  }
}

TEST(PngImageTest, PartsOfPicturesAreWritten) {
  const cv::Mat image = Noise(CV_8UC3), part = image(cv::Rect(3, 2, 10, 11));
  EXPECT_TRUE(Same(DecodePng(EncodePng(part)), part));
}

TEST(PngImageTest, ReadsWhatOthersWrite) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat image = Noise(type);
    EXPECT_TRUE(Same(DecodePng(FromOpenCv(image)), image));
  }
  const cv::Mat with_alpha = Noise(CV_8UC4), colour = DecodePng(FromOpenCv(with_alpha));
  ASSERT_EQ(colour.type(), CV_8UC3);
  EXPECT_EQ(colour.at<cv::Vec3b>(4, 5)[1], with_alpha.at<cv::Vec4b>(4, 5)[1]);
}

TEST(PngImageTest, DamageAtAnyByteIsNoCrash) {
  const std::string whole = EncodePng(Noise(CV_8UC3));
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    EXPECT_TRUE(DecodePng(std::string_view(whole).substr(0, at)).empty()) << "cut at " << at;
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
    const cv::Mat image = DecodePng(damaged);
    EXPECT_TRUE(image.empty() || Same(image, Noise(CV_8UC3))) << "changed at " << at;
  }
}

TEST(PngImageTest, DeepPicturesAreNotRead) { EXPECT_TRUE(DecodePng(FromOpenCv(Noise(CV_16UC3))).empty()); }

TEST(PngImageTest, AFloatPictureIsAContractBroken) {
  EXPECT_THROW(EncodePng(cv::Mat(2, 2, CV_32FC1)), std::logic_error);
  EXPECT_THROW(EncodePng(cv::Mat()), std::logic_error);
}

}  // namespace
}  // namespace dorsum
