// SPDX-License-Identifier: Apache-2.0
#include "imaging/hand_mask.h"

#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "imaging/stage_sink.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

constexpr int kWidth = 160, kHeight = 120;
const cv::Rect kObject(50, 30, 60, 50);

// A bright backplane that falls off to a third towards the corners.
cv::Mat Backplane() {
  cv::Mat image(kHeight, kWidth, CV_8UC3);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double r2 = (std::pow(u - 80.0, 2) + std::pow(v - 60.0, 2)) / 10000.0;
      image.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(210.0 * (1.0 - 0.66 * r2)));
    }
  }
  return image;
}

cv::Mat Noisy(const cv::Mat& image, int seed) {
  cv::Mat noise(image.size(), CV_16SC3), out;
  cv::RNG rng(static_cast<std::uint64_t>(seed));
  rng.fill(noise, cv::RNG::NORMAL, 0, 2);
  image.convertTo(out, CV_16SC3);
  out += noise;
  out.convertTo(out, CV_8UC3);
  return out;
}

// Multiplies a part of the image, as an object of that reflectance or a shadow does.
void Darken(cv::Mat* image, const cv::Rect& part, double factor) { (*image)(part) *= factor; }

double Agreement(const cv::Mat& mask, const cv::Rect& object) {
  cv::Mat truth = cv::Mat::zeros(mask.size(), CV_8UC1);
  truth(object).setTo(255);
  return 1.0 - static_cast<double>(cv::countNonZero(mask != truth)) / static_cast<double>(object.area());
}

TEST(HandMask, ADarkObjectIsFoundInTheBrightMiddleAndInADarkCorner) {
  for (const cv::Rect& object : {kObject, cv::Rect(0, 0, 40, 30)}) {
    cv::Mat hand = Backplane();
    Darken(&hand, object, 0.35);
    const auto mask = ExtractHandMask(Noisy(Backplane(), 1), Noisy(hand, 2), {});
    ASSERT_TRUE(mask.ok()) << mask.error().message;
    EXPECT_GT(Agreement(mask->mask, object), 0.98);
    EXPECT_NEAR(mask->area_share, static_cast<double>(object.area()) / (kWidth * kHeight), 0.003);
  }
}

TEST(HandMask, AnObjectBrighterThanTheBackgroundIsFoundToo) {
  const cv::Mat background(kHeight, kWidth, CV_8UC3, cv::Scalar::all(60));
  cv::Mat hand = background.clone();
  hand(kObject).setTo(cv::Scalar::all(200));
  const auto mask = ExtractHandMask(background, hand, {});
  ASSERT_TRUE(mask.ok());
  EXPECT_GT(Agreement(mask->mask, kObject), 0.98);
}

TEST(HandMask, ALightShadowIsNotTheObject) {
  cv::Mat hand = Backplane();
  Darken(&hand, kObject, 0.3);
  Darken(&hand, cv::Rect(110, 30, 25, 50), 0.85);
  const auto mask = ExtractHandMask(Backplane(), hand, {});
  ASSERT_TRUE(mask.ok());
  EXPECT_GT(Agreement(mask->mask, kObject), 0.98);
}

TEST(HandMask, SpecksAndASecondSmallerThingAreDropped) {
  cv::Mat hand = Backplane();
  Darken(&hand, kObject, 0.35);
  for (int i = 0; i < 12; ++i) Darken(&hand, cv::Rect(10 + 12 * i, 100, 3, 3), 0.2);
  Darken(&hand, cv::Rect(5, 5, 12, 12), 0.3);
  const auto mask = ExtractHandMask(Backplane(), hand, {});
  ASSERT_TRUE(mask.ok());
  EXPECT_GT(Agreement(mask->mask, kObject), 0.98);
  EXPECT_EQ(cv::countNonZero(mask->mask.rowRange(95, 120)), 0);
  EXPECT_EQ(mask->mask.at<std::uint8_t>(10, 10), 0);
}

TEST(HandMask, AnEmptySceneIsAnErrorThatAsksForAHand) {
  for (const auto& hand : {Backplane(), Noisy(Backplane(), 3)}) {
    const auto mask = ExtractHandMask(Backplane(), hand, {});
    ASSERT_FALSE(mask.ok());
    EXPECT_EQ(mask.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(mask.error().message, HasSubstr("no hand"));
  }
}

TEST(HandMask, AnObjectTooSmallIsNoHand) {
  cv::Mat hand = Backplane();
  Darken(&hand, cv::Rect(70, 60, 8, 8), 0.2);
  const auto mask = ExtractHandMask(Backplane(), hand, {});
  ASSERT_FALSE(mask.ok());
  EXPECT_THAT(mask.error().message, HasSubstr("no hand"));
}

TEST(HandMask, ALightThatChangedIsToldFromAnEmptyScene) {
  cv::Mat dim = Backplane();
  Darken(&dim, cv::Rect(0, 0, kWidth, kHeight), 0.5);
  cv::Mat nearly = Backplane();
  Darken(&nearly, cv::Rect(0, 0, kWidth - 6, kHeight), 0.3);
  for (const cv::Mat& hand : {dim, nearly}) {
    const auto mask = ExtractHandMask(Backplane(), hand, {});
    ASSERT_FALSE(mask.ok());
    EXPECT_EQ(mask.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(mask.error().message, ::testing::Not(HasSubstr("no hand")));
  }
}

TEST(HandMask, AnyAllowedOpeningWorks) {
  cv::Mat hand = Backplane();
  Darken(&hand, kObject, 0.35);
  for (const int open_px : {1, 2, 8, 49}) {
    HandMaskOptions options;
    options.open_px = open_px;
    EXPECT_TRUE(ExtractHandMask(Backplane(), hand, options).ok()) << open_px;
  }
}

TEST(HandMask, TheStagesAreHandedOut) {
  struct Keep : StageSink {
    void Image(const std::string& key, const cv::Mat& image) override { images[key] = image.clone(); }
    std::map<std::string, cv::Mat> images;
  } keep;
  Context context;
  context.sink = &keep;
  cv::Mat hand = Backplane();
  Darken(&hand, kObject, 0.35);
  const auto mask = ExtractHandMask(Backplane(), hand, {}, context);
  ASSERT_TRUE(mask.ok());
  EXPECT_EQ(keep.images.size(), 3U);
  EXPECT_EQ(cv::norm(keep.images["mask/mask"], mask->mask, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace dorsum
