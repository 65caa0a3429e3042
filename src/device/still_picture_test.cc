// SPDX-License-Identifier: Apache-2.0
#include "device/still_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "device/scripted_frames_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const cv::Size kSize(320, 240);

// Stripes every 32 px, as a laser draws them; `phase` tells lasers apart, LEDs give an even grey.
cv::Mat StripesAt(int phase) {
  cv::Mat image(kSize, CV_8UC3, cv::Scalar(4, 8, 4));
  for (int x = phase; x < kSize.width; x += 32)
    image.colRange(x, std::min(x + 3, kSize.width)) = cv::Scalar(12, 180, 15);
  return image;
}
cv::Mat UnderLeds() { return {kSize, CV_8UC3, cv::Scalar(110, 120, 100)}; }

cv::Mat Noisy(const cv::Mat& image, double sigma, int seed) {
  cv::Mat noise(image.size(), CV_16SC3), sum;
  cv::RNG rng(static_cast<std::uint64_t>(seed) * 7919 + 1);
  rng.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
  cv::add(image, noise, sum, cv::noArray(), CV_8U);
  return sum;
}

// The rows of a rolling shutter: row r is exposed r / rows * readout after the frame's begin; old before the
// change, new after it, and a mixture of both while it is exposed.
cv::Mat RollingShutter(const cv::Mat& before, const cv::Mat& after, double begin_s, double changed_at_s,
                       double readout_s, double exposure_s) {
  cv::Mat image(before.size(), CV_8UC3);
  for (int row = 0; row < image.rows; ++row) {
    const double row_begin = begin_s + readout_s * row / image.rows;
    const double share = std::clamp((row_begin + exposure_s - changed_at_s) / exposure_s, 0.0, 1.0);
    cv::addWeighted(before.row(row), 1.0 - share, after.row(row), share, 0.0, image.row(row));
  }
  return image;
}

double WorstDifference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(TakeStillTest, FramesFromBeforeTheChangeArePassedOver) {
  const cv::Mat before = StripesAt(4), after = StripesAt(20);
  double changed_at = 0.0;
  ScriptedFrames camera(kSize, [&](double t, int) { return (t < changed_at ? before : after).clone(); });
  camera.exact = true;
  changed_at = camera.now_s + 0.4;
  const auto still = TakeStill(camera, changed_at, {}, {});
  ASSERT_TRUE(still.ok()) << still.error().message;
  EXPECT_EQ(WorstDifference(*still, after), 0.0);
  EXPECT_GE(camera.now_s, changed_at);
  EXPECT_LT(camera.now_s, changed_at + 0.15) << "no longer than it needs";
}

TEST(TakeStillTest, StampsOfArrivalDoNotMakeFramesInAQueueNew) {
  // Up to fifteen frames of the old light come out of a queue after the change, stamped as they arrive.
  for (const int stale : {1, 2, 4, 8, 15}) {
    for (const bool has_before : {false, true}) {
      const cv::Mat before = StripesAt(4), after = StripesAt(20);
      double changed_at = 0.0;
      ScriptedFrames camera(kSize,
                            [&](double t, int i) { return Noisy(t < changed_at ? before : after, 2.0, i); });
      camera.noisy = true;
      camera.latency_s = (stale + 0.5) * camera.interval_s;
      changed_at = camera.now_s;
      StillOptions options;
      if (has_before) options.before = Noisy(before, 2.0, 99999);
      const auto still = TakeStill(camera, changed_at, options, {});
      ASSERT_TRUE(still.ok()) << still.error().message;
      EXPECT_LT(cv::norm(*still, after, cv::NORM_L1) / (3.0 * kSize.area()), 2.0) << stale;
      EXPECT_LE(camera.given, stale + 4) << "no longer than it needs";
    }
  }
}

TEST(TakeStillTest, FrameHalfOldAndHalfNewIsPassedOver) {
  // Every place of the change within a frame, for short and for long exposures.
  for (const double exposure : {0.004, 0.015, 0.033}) {
    for (double place = 0.0; place < 1.0; place += 0.05) {
      const cv::Mat before = UnderLeds(), after = StripesAt(12);
      double changed_at = 0.0;
      ScriptedFrames camera(kSize, [&](double t, int i) {
        return Noisy(RollingShutter(before, after, t, changed_at, 0.03, exposure), 1.5, i);
      });
      camera.noisy = true;
      camera.latency_s = 0.033 + exposure;  // stamped as it arrives
      changed_at = camera.now_s + place * camera.interval_s;
      StillOptions options;
      options.delay_s = 0.0;  // nothing but what the frames show
      const auto still = TakeStill(camera, changed_at, options, {});
      ASSERT_TRUE(still.ok()) << still.error().message;
      for (int band = 0; band < kSize.height; band += 8) {
        const cv::Mat a = still->rowRange(band, band + 8), b = after.rowRange(band, band + 8);
        EXPECT_LT(cv::norm(a, b, cv::NORM_L1) / (3.0 * a.total()), 2.0)
            << "rows from " << band << ", change at " << place << ", exposure " << exposure;
      }
    }
  }
}

TEST(TakeStillTest, ExposureThatCreepsToItsValueIsWaitedFor) {
  const cv::Mat before = StripesAt(4), after = UnderLeds();
  double changed_at = 0.0;
  ScriptedFrames camera(kSize, [&](double t, int i) -> cv::Mat {
    if (t < changed_at) return Noisy(before, 1.0, i);
    return Noisy(after * (1.0 - 0.6 * std::exp(-(t - changed_at) / 0.1)), 1.0, i);
  });
  changed_at = camera.now_s + 0.1;
  const auto still = TakeStill(camera, changed_at, {}, {});
  ASSERT_TRUE(still.ok()) << still.error().message;
  EXPECT_NEAR(cv::mean(*still)[1], 120.0, 120.0 * 0.08);
}

TEST(TakeStillTest, LightThatChangesNothingEndsInTheUnchangedPicture) {
  const cv::Mat scene = StripesAt(4);
  ScriptedFrames camera(kSize, [&](double, int i) { return Noisy(scene, 2.0, i); });
  camera.noisy = true;
  const double changed_at = camera.now_s;
  const auto still = TakeStill(camera, changed_at, {}, {});
  ASSERT_TRUE(still.ok()) << still.error().message;
  EXPECT_GE(camera.now_s, changed_at + 1.0) << "old frames may come for so long";
  EXPECT_LT(camera.now_s, changed_at + 1.2);

  camera.exact = true;  // whoever knows when its frames were exposed is believed
  const double again = camera.now_s;
  ASSERT_TRUE(TakeStill(camera, again, {}, {}).ok());
  EXPECT_LT(camera.now_s, again + 0.15);
}

TEST(TakeStillTest, UnchangedPictureComesWithinATimeOutShorterThanTheWaitForOldFrames) {
  ScriptedFrames camera(kSize, [&](double, int i) { return Noisy(StripesAt(4), 2.0, i); });
  StillOptions options;
  options.timeout_s = 0.8;
  options.stale_s = 10.0;
  EXPECT_TRUE(TakeStill(camera, camera.now_s, options, {}).ok());
}

TEST(TakeStillTest, AverageIsRoundedAndQuietens) {
  const cv::Mat scene = UnderLeds();
  ScriptedFrames camera(kSize, [&](double, int i) { return Noisy(scene, 4.0, i); });
  camera.exact = true;
  StillOptions options;
  options.average = 16;
  const auto still = TakeStill(camera, camera.now_s, options, {});
  ASSERT_TRUE(still.ok()) << still.error().message;
  cv::Scalar mean, deviation;
  cv::meanStdDev(*still, mean, deviation);
  EXPECT_NEAR(mean[1], 120.0, 0.05) << "cutting off instead of rounding takes half a grey level";
  EXPECT_LT(deviation[1], 1.2);
  EXPECT_GT(deviation[1], 0.8) << "a quarter of 4, and rounding";
}

TEST(TakeStillTest, AverageIsThatOfTheFramesGiven) {
  // Values 100, 101, 100, 101, … : the mean 100.5 rounds up; 64 frames of white do not overflow.
  int level = 100;
  ScriptedFrames camera(kSize, [&](double, int i) {
    return cv::Mat(kSize, CV_8UC3, cv::Scalar::all(level == 255 ? 255 : level + i % 2));
  });
  camera.exact = true;
  StillOptions options;
  options.average = 2;
  auto still = TakeStill(camera, camera.now_s, options, {});
  ASSERT_TRUE(still.ok());
  EXPECT_EQ(WorstDifference(*still, cv::Mat(kSize, CV_8UC3, cv::Scalar::all(101))), 0.0);
  level = 255;
  options.average = 64;
  still = TakeStill(camera, camera.now_s, options, {});
  ASSERT_TRUE(still.ok());
  EXPECT_EQ(WorstDifference(*still, cv::Mat(kSize, CV_8UC3, cv::Scalar::all(255))), 0.0);
}

TEST(TakeStillTest, FlickerOfMainsLightAndATremblingHandSettle) {
  const cv::Mat scene = StripesAt(12);
  ScriptedFrames camera(kSize, [&](double, int i) -> cv::Mat {
    const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 0.4 * std::sin(i * 2.1), 0, 1, 0);
    cv::Mat moved;
    cv::warpAffine(scene, moved, shift, kSize, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    return Noisy(moved * (1.0 + 0.01 * std::sin(i * 1.3)), 1.0, i);
  });
  camera.exact = true;
  EXPECT_TRUE(TakeStill(camera, camera.now_s, {}, {}).ok());
}

TEST(TakeStillTest, PictureThatNeverSettlesIsAnErrorThatSaysSo) {
  ScriptedFrames camera(kSize, [](double, int i) { return StripesAt(i * 5 % 32); });
  const auto still = TakeStill(camera, camera.now_s, {}, {});
  ASSERT_FALSE(still.ok());
  EXPECT_EQ(still.error().code, ErrorCode::kDevice);
  EXPECT_THAT(still.error().message, AllOf(HasSubstr("scripted camera"),
                                           HasSubstr("did not settle within 5 s"), HasSubstr("grey levels")));
}

TEST(TakeStillTest, FrozenCameraIsAnErrorAndANoiselessReplayIsNot) {
  ScriptedFrames camera(kSize, [](double, int) { return StripesAt(4); });
  EXPECT_TRUE(TakeStill(camera, camera.now_s, {}, {}).ok());
  camera.noisy = true;
  const double start = camera.now_s;
  const auto still = TakeStill(camera, start, {}, {});
  ASSERT_FALSE(still.ok());
  EXPECT_EQ(still.error().code, ErrorCode::kDevice);
  EXPECT_THAT(still.error().message, HasSubstr("frozen"));
  EXPECT_LT(camera.now_s, start + 1.5) << "long before the time-out";
}

TEST(TakeStillTest, BlackRepeatsWithoutBeingFrozen) {
  ScriptedFrames camera(kSize, [](double, int) { return cv::Mat(kSize, CV_8UC3, cv::Scalar::all(0)); });
  camera.noisy = true;
  const auto still = TakeStill(camera, camera.now_s, {}, {});
  ASSERT_TRUE(still.ok()) << still.error().message;
  EXPECT_EQ(cv::countNonZero(still->reshape(1)), 0);
}

TEST(TakeStillTest, FrameSentTwiceIsNotTakenForASettledOne) {
  // A server that is quicker than its sensor: each picture comes twice, also the one half old and half new.
  const cv::Mat before = UnderLeds(), after = StripesAt(4);
  cv::Mat half = before.clone();
  after.rowRange(120, 240).copyTo(half.rowRange(120, 240));
  ScriptedFrames camera(kSize, [&](double, int i) {
    const int n = i / 2;
    return Noisy(n < 3 ? before : n == 3 ? half : after, 2.0, n);
  });
  camera.noisy = true;
  const auto still = TakeStill(camera, camera.now_s, {}, {});
  ASSERT_TRUE(still.ok()) << still.error().message;
  EXPECT_LT(cv::norm(*still, after, cv::NORM_L1) / (3.0 * kSize.area()), 2.0);
}

TEST(TakeStillTest, CameraThatIsGoneIsReportedAtOnce) {
  ScriptedFrames camera(kSize, [](double, int i) { return Noisy(StripesAt(4), 2.0, i); });
  camera.last_frame = 3;
  const auto still = TakeStill(camera, camera.now_s, {}, {});
  ASSERT_FALSE(still.ok());
  EXPECT_EQ(still.error().code, ErrorCode::kDevice);
  EXPECT_THAT(still.error().message, HasSubstr("gone"));
}

TEST(TakeStillTest, FrameOfAnotherSizeIsAnError) {
  ScriptedFrames camera(kSize, [](double, int) { return cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(9)); });
  const auto still = TakeStill(camera, camera.now_s, {}, {});
  ASSERT_FALSE(still.ok());
  EXPECT_THAT(still.error().message, AllOf(HasSubstr("100x100"), HasSubstr("320x240")));
}

TEST(TakeStillTest, SlowCameraSaysThatItIsTooSlow) {
  ScriptedFrames camera(kSize, [](double, int i) { return Noisy(StripesAt(4), 2.0, i); });
  camera.interval_s = 6.0;
  const auto still = TakeStill(camera, camera.now_s, {}, {});
  ASSERT_FALSE(still.ok());
  EXPECT_THAT(still.error().message, HasSubstr("too slow"));
}

TEST(TakeStillTest, InterruptionComesBeforeThePicture) {
  ScriptedFrames camera(kSize, [](double, int i) { return StripesAt(i * 5 % 32); });
  std::atomic<bool> cancel = false;
  Context context;
  context.cancel = &cancel;
  cancel = true;
  const auto still = TakeStill(camera, camera.now_s, {}, context);
  ASSERT_FALSE(still.ok());
  EXPECT_EQ(still.error().code, ErrorCode::kCancelled);
  EXPECT_EQ(camera.given, 0);
}

}  // namespace
}  // namespace dorsum
