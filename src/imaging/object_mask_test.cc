// SPDX-License-Identifier: Apache-2.0
#include "imaging/object_mask.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dorsum {
namespace {

const cv::Size kSize(320, 240);
constexpr float kPaper = 160.0F;

// A scene of an object of even albedo with a soft shadow to its lower right, with noise; and seeds on stripes
// `spacing` px apart, none in the 8 px to the object's left, where the lasers throw their shadow.
struct Scene {
  cv::Mat background, hand, truth;
  std::vector<ObjectSeed> seeds;
};

cv::Mat Picture(const cv::Mat& light, int noise_seed) {
  cv::Mat noise(light.size(), CV_32FC1), green;
  cv::RNG rng(static_cast<std::uint64_t>(noise_seed));
  rng.fill(noise, cv::RNG::NORMAL, 0.0, 1.5);
  cv::GaussianBlur(light, green, {}, 0.8);
  green += noise;
  green.convertTo(green, CV_8U);
  cv::Mat picture;
  cv::merge(std::vector<cv::Mat>{green * 0.1, green, green * 0.1}, picture);
  return picture;
}

Scene MakeScene(const cv::Mat& truth, float albedo, int spacing) {
  Scene scene;
  scene.truth = truth;
  cv::Mat shadow, paper(kSize, CV_32FC1, cv::Scalar(kPaper));
  const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1.0, 0.0, 10.0, 0.0, 1.0, 12.0);
  cv::warpAffine(truth, shadow, shift, kSize);
  shadow.convertTo(shadow, CV_32F, 1.0 / 255.0);
  cv::GaussianBlur(shadow, shadow, {}, 4.0);
  cv::Mat light = paper.mul(1.0 - 0.7 * shadow);
  light.setTo(kPaper * albedo, truth);
  scene.background = Picture(paper, 1);
  scene.hand = Picture(light, 2);
  for (int v = 0; v < kSize.height; ++v) {
    for (int u = 5; u < kSize.width; u += spacing) {
      const bool object = truth.at<std::uint8_t>(v, u) != 0;
      const bool hidden = !object && u + 8 < kSize.width && truth.at<std::uint8_t>(v, u + 8) != 0;
      if (hidden) continue;
      scene.seeds.push_back({static_cast<float>(u), static_cast<float>(v), object});
    }
  }
  return scene;
}

// Three fingers that come in from the left, 6 px apart.
cv::Mat Fingers() {
  cv::Mat truth = cv::Mat::zeros(kSize, CV_8UC1);
  cv::rectangle(truth, {0, 80}, {120, 157}, 255, cv::FILLED);
  for (const int v : {80, 108, 136}) {
    cv::rectangle(truth, {120, v}, {230, v + 21}, 255, cv::FILLED);
    cv::circle(truth, {230, v + 11}, 10, 255, cv::FILLED);
  }
  return truth;
}

cv::Mat Refine(const Scene& scene, int threads = 1) {
  Context context;
  context.threads = threads;
  const auto mask =
      RefineObjectMask(scene.background, scene.hand, FindObjectLight(scene.background, scene.hand, {}),
                       scene.seeds, {}, context);
  EXPECT_TRUE(mask.ok());
  return mask.ok() ? mask->mask : cv::Mat::zeros(kSize, CV_8UC1);
}

// Pixels of one mask that are more than 2 px from the other.
int Beyond(const cv::Mat& mask, const cv::Mat& other) {
  cv::Mat distance;
  cv::distanceTransform(other == 0, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return cv::countNonZero(mask & (distance > 2.0));
}

void ExpectNearTruth(const Scene& scene) {
  const cv::Mat mask = Refine(scene);
  const double area = cv::countNonZero(scene.truth);
  EXPECT_LE(Beyond(mask, scene.truth), 0.005 * area);
  EXPECT_LE(Beyond(~mask, ~scene.truth), 0.002 * area);
  EXPECT_LT(cv::countNonZero(mask != scene.truth), 0.05 * area);
}

TEST(RefineObjectMask, ShadowIsNotTheObjectAndNarrowGapsStayOpen) {
  ExpectNearTruth(MakeScene(Fingers(), 0.4F, 12));
}

TEST(RefineObjectMask, AWhiteObjectOnTheWhiteBackplaneIsOutlinedByItsStripes) {
  cv::Mat truth = cv::Mat::zeros(kSize, CV_8UC1);
  cv::rectangle(truth, {62, 60}, {200, 160}, 255, cv::FILLED);
  ExpectNearTruth(MakeScene(truth, 1.02F, 10));
}

TEST(RefineObjectMask, AHoleStaysAHole) {
  cv::Mat truth = cv::Mat::zeros(kSize, CV_8UC1);
  cv::circle(truth, {150, 120}, 70, 255, cv::FILLED);
  cv::circle(truth, {150, 120}, 20, 0, cv::FILLED);
  ExpectNearTruth(MakeScene(truth, 0.5F, 10));
}

TEST(RefineObjectMask, AFewWrongSeedsDoNoHarm) {
  Scene scene = MakeScene(Fingers(), 0.4F, 12);
  for (std::size_t i = 0; i < scene.seeds.size(); i += 100) scene.seeds[i].object = !scene.seeds[i].object;
  ExpectNearTruth(scene);
}

TEST(RefineObjectMask, ABrightRingPartsNoFinger) {
  Scene scene = MakeScene(Fingers(), 0.4F, 12);
  const cv::Rect ring(170, 109, 10, 20);
  scene.hand(ring).setTo(cv::Scalar(17, 170, 17));
  std::erase_if(scene.seeds, [&](const ObjectSeed& s) {
    return ring.contains(cv::Point(static_cast<int>(s.u), static_cast<int>(s.v)));
  });
  ExpectNearTruth(scene);
}

TEST(RefineObjectMask, OneLaserIsEnough) { ExpectNearTruth(MakeScene(Fingers(), 0.4F, 45)); }

TEST(RefineObjectMask, TheSameBytesAtAnyNumberOfThreads) {
  const Scene scene = MakeScene(Fingers(), 0.4F, 12);
  EXPECT_EQ(cv::norm(Refine(scene, 1), Refine(scene, 4), cv::NORM_INF), 0.0);
}

TEST(RefineObjectMask, OddSizesAndSeedsOutsideTheImage) {
  Scene scene = MakeScene(Fingers(), 0.4F, 12);
  const cv::Rect odd(0, 0, kSize.width - 1, kSize.height - 1);
  for (cv::Mat* m : {&scene.background, &scene.hand, &scene.truth}) *m = (*m)(odd).clone();
  scene.seeds.push_back({-7.0F, 10.0F, true});
  scene.seeds.push_back({1e6F, 1e6F, true});
  ExpectNearTruth(scene);
}

TEST(RefineObjectMask, WithoutSeedsThePictureDecides) {
  Scene scene = MakeScene(Fingers(), 0.4F, 12);
  scene.seeds.clear();
  const cv::Mat mask = Refine(scene);
  EXPECT_EQ(Beyond(~mask, ~scene.truth), 0);
}

TEST(RefineObjectMask, SaysHowManySeedsContradictTheOutline) {
  Scene scene = MakeScene(Fingers(), 0.4F, 12);
  for (std::size_t i = 0; i < scene.seeds.size(); i += 100) scene.seeds[i].object = !scene.seeds[i].object;
  const auto mask = RefineObjectMask(scene.background, scene.hand,
                                     FindObjectLight(scene.background, scene.hand, {}), scene.seeds, {});
  ASSERT_TRUE(mask.ok());
  EXPECT_NEAR(mask->contradicting, 0.01, 0.003);
}

TEST(RefineObjectMask, ScatteredWrongSeedsOnAnEmptyBackplaneAreNoObject) {
  Scene scene = MakeScene(cv::Mat::zeros(kSize, CV_8UC1), 1.0F, 12);
  for (std::size_t i = 0; i < scene.seeds.size(); i += 71) scene.seeds[i].object = true;
  const auto mask = RefineObjectMask(scene.background, scene.hand,
                                     FindObjectLight(scene.background, scene.hand, {}), scene.seeds, {});
  ASSERT_FALSE(mask.ok());
  EXPECT_NE(mask.error().message.find("no object is seen"), std::string::npos);
}

TEST(RefineObjectMask, AnObjectWithoutAnOutlineIsAnError) {
  Scene scene = MakeScene(cv::Mat::zeros(kSize, CV_8UC1), 1.0F, 12);
  for (ObjectSeed& seed : scene.seeds) seed.object = true;
  const auto mask = RefineObjectMask(scene.background, scene.hand,
                                     FindObjectLight(scene.background, scene.hand, {}), scene.seeds, {});
  ASSERT_FALSE(mask.ok());
  EXPECT_NE(mask.error().message.find("fill the picture"), std::string::npos);
}

TEST(RefineObjectMask, NothingThereIsAnError) {
  const Scene scene = MakeScene(cv::Mat::zeros(kSize, CV_8UC1), 1.0F, 12);
  const auto mask = RefineObjectMask(scene.background, scene.hand,
                                     FindObjectLight(scene.background, scene.hand, {}), scene.seeds, {});
  ASSERT_FALSE(mask.ok());
  EXPECT_EQ(mask.error().code, ErrorCode::kBadInput);
  EXPECT_NE(mask.error().message.find("bgHand"), std::string::npos);
}

}  // namespace
}  // namespace dorsum
