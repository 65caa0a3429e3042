// SPDX-License-Identifier: Apache-2.0
#include "studio/hand_advice.h"

#include <chrono>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "jobs/scan_fixture_test.h"
#include "studio/finger_quality.h"
#include "studio/hand_fingers.h"

namespace dorsum {
namespace {

cv::Mat Background() {
  static const cv::Mat picture = cv::imread((ScanFixture::CalibrationDir() / "bgNoHand.png").string());
  return picture;
}
cv::Mat Picture(const std::string& capture) {
  return cv::imread((ScanFixture::CaptureDir(capture) / "bgHand.png").string());
}

// What share of the light a hand leaves at each pixel.
cv::Mat LightLeft() {
  cv::Mat background, hand, left;
  Background().convertTo(background, CV_32F);
  Picture(ScanFixture::kHand).convertTo(hand, CV_32F);
  cv::divide(hand, cv::max(background, cv::Scalar::all(1.0)), left);
  return left;
}

cv::Mat Under(const cv::Mat& light) {
  cv::Mat background, picture;
  Background().convertTo(background, CV_32F);
  cv::multiply(background, light, picture);
  picture.convertTo(picture, CV_8U);
  return picture;
}

// The hand pushed about on the backplane; its arm grows with it.
cv::Mat Pushed(double right, double down) {
  const cv::Mat move = (cv::Mat_<double>(2, 3) << 1, 0, right, 0, 1, down);
  cv::Mat moved;
  cv::warpAffine(LightLeft(), moved, move, Background().size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return Under(moved);
}

// After a second of rest.
HandView Rested(const cv::Mat& picture) {
  HandAdvisor advisor(Background());
  advisor.Look(picture, 0.0);
  return advisor.Look(picture, 1.0);
}

TEST(HandAdvice, AHandThatLiesWellAndRestsIsGood) {
  const HandView view = Rested(Picture(ScanFixture::kHand));
  EXPECT_EQ(view.advice, Advice::kGood);
  EXPECT_EQ(view.fingers, 5);
  EXPECT_EQ(view.rested_s, 1.0);
  EXPECT_GT(view.area_share, 0.1);
  EXPECT_EQ(view.outlines.size(), 1U);
}

TEST(HandAdvice, AnEmptyBackplaneAsksForAHand) {
  EXPECT_EQ(Rested(Background()).advice, Advice::kPutHandDown);
  EXPECT_TRUE(Rested(Background()).outlines.empty());
}

TEST(HandAdvice, LightThatChangedIsNoHand) {
  EXPECT_EQ(Rested(cv::Mat(0.3 * Background())).advice, Advice::kLightChanged);
  EXPECT_EQ(Rested(cv::Mat::zeros(Background().size(), CV_8UC3)).advice, Advice::kLightChanged);
}

TEST(HandAdvice, AHandThatLeavesThePictureIsCalledBack) {
  EXPECT_EQ(Rested(Pushed(120, 0)).advice, Advice::kMoveLeft);
  EXPECT_EQ(Rested(Pushed(-230, 0)).advice, Advice::kMoveRight);
  EXPECT_EQ(Rested(Pushed(0, -80)).advice, Advice::kMoveDown);
  EXPECT_EQ(Rested(Pushed(0, 130)).advice, Advice::kMoveUp);
}

TEST(HandAdvice, FingersTogetherAreToBeSpread) {
  cv::Mat light = LightLeft(), joined;
  cv::morphologyEx(light, joined, cv::MORPH_OPEN, cv::Mat::ones(41, 41, CV_8UC1));
  EXPECT_EQ(Rested(Under(joined)).advice, Advice::kSpreadFingers);
}

TEST(HandAdvice, ABoxIsNoHandWithFingers) {
  EXPECT_EQ(Rested(Picture(ScanFixture::kBox)).advice, Advice::kSpreadFingers);
  EXPECT_EQ(Rested(Picture(ScanFixture::kSphere)).advice, Advice::kSpreadFingers);
}

TEST(HandAdvice, AHandThatMovesIsToldToHoldStillHoweverSlowly) {
  HandAdvisor advisor(Background());
  advisor.Look(Pushed(0, 0), 0.0);
  EXPECT_EQ(advisor.Look(Pushed(3, 0), 0.5).advice, Advice::kHoldStill);
  // Half a pixel each time: no two neighbours tell, but it does not rest for a second.
  double longest = 0.0;
  for (int i = 1; i <= 12; ++i) {
    longest = std::max(longest, advisor.Look(Pushed(3 + 0.5 * i, 0), 0.5 + 0.3 * i).rested_s);
  }
  EXPECT_LT(longest, 1.0);
}

TEST(HandAdvice, NoiseIsNoMotion) {
  HandAdvisor advisor(Background());
  cv::RNG random(7);
  const cv::Mat still = Picture(ScanFixture::kHand);
  for (int i = 0; i < 40; ++i) {
    cv::Mat noise(still.size(), CV_16SC3), noisy;
    random.fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
    cv::add(still, noise, noisy, {}, CV_8UC3);
    EXPECT_EQ(advisor.Look(noisy, 0.1 * i).rested_s, 0.1 * i);
  }
}

TEST(HandAdvice, APictureOfAnotherSizeIsRefused) {
  HandAdvisor advisor(Background());
  EXPECT_THROW(advisor.Look(cv::Mat::zeros(10, 10, CV_8UC3), 0.0), std::logic_error);
}

TEST(HandAdvice, ALargePictureTakesMilliseconds) {
  cv::Mat background, hand;
  cv::resize(Background(), background, {1600, 1200});
  cv::resize(Picture(ScanFixture::kHand), hand, {1600, 1200});
  HandAdvisor advisor(background);
  advisor.Look(hand, 0.0);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(advisor.Look(hand, 1.0 + i).fingers, 5);
    best = std::min(
        best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  RecordProperty("milliseconds", std::to_string(best));
  std::printf("[ figure ] a look at 1600 x 1200: %.1f ms\n", best);
}

TEST(HandFingers, AreNumberedFromLeftToRightAsTheirOwnerSeesThem) {
  const HandView view = Rested(Picture(ScanFixture::kHand));
  cv::Mat mask = cv::Mat::zeros(view.picture.size(), CV_8UC1);
  cv::drawContours(mask, view.outlines, -1, cv::Scalar(255), cv::FILLED);
  const HandParts parts = FindFingers(mask);
  ASSERT_EQ(parts.fingers.size(), 5U);
  // The hand points to the right of the picture: its owner's left is the picture's upper side.
  double before = 0.0;
  for (const cv::Mat& finger : parts.fingers) {
    const cv::Moments m = cv::moments(finger, true);
    EXPECT_GT(m.m01 / m.m00, before);
    before = m.m01 / m.m00;
  }
  EXPECT_TRUE(FindFingers(cv::Mat::zeros(100, 100, CV_8UC1)).fingers.empty());
  EXPECT_TRUE(FindFingers(cv::Mat(100, 100, CV_8UC1, cv::Scalar(255))).fingers.empty());
}

TEST(FingerQuality, NothingIsToldOfWhatHasNoFingers) { EXPECT_TRUE(JudgeFingers({}, {}).empty()); }

}  // namespace
}  // namespace dorsum
