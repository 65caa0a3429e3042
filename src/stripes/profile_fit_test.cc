// SPDX-License-Identifier: Apache-2.0
#include "stripes/profile_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "stripes/synthetic_stripes_test.h"

namespace dorsum {
namespace {

// A row of 61 pixels with a Gaussian on a background; light ends beyond `edge`.
std::vector<std::uint8_t> Row(double u, double width, double amplitude, double background, double noise_sd,
                              Rng* rng, double edge = 1e9) {
  std::vector<std::uint8_t> row;
  for (int x = 0; x <= 60; ++x) {
    const double t = (x - u) / width;
    const double light = x > edge ? 0.0 : amplitude * std::exp(-0.5 * t * t);
    row.push_back(static_cast<std::uint8_t>(
        std::lround(std::clamp(background + light + noise_sd * rng->Normal(), 0.0, 255.0))));
  }
  return row;
}

ProfileStart Start(double u, double width) {
  ProfileStart start;
  start.u = u;
  start.width = width;
  start.last = 60;
  return start;
}

TEST(ProfileFit, FindsAllFourUnknownsFromAPoorStart) {
  Rng rng(1);
  const std::vector<std::uint8_t> row = Row(30.37, 2.6, 120.0, 9.0, 0.0, &rng);
  const ProfileFit fit = FitProfile(row.data(), Start(31.5, 1.8), {}, {});
  ASSERT_TRUE(fit.ok);
  EXPECT_FALSE(fit.width_held);
  EXPECT_NEAR(fit.u, 30.37, 0.02);
  EXPECT_NEAR(fit.width, 2.6, 0.03);
  EXPECT_NEAR(fit.amplitude, 120.0, 1.0);
  EXPECT_NEAR(fit.background, 9.0, 0.7);
}

TEST(ProfileFit, MeetsTheBoundAndItsDeviationIsHonest) {
  Rng rng(2);
  double square = 0.0, normal = 0.0, bound = 0.0;
  constexpr int kRows = 2000;
  for (int i = 0; i < kRows; ++i) {
    const double u = 30.0 + rng.Uniform();
    const std::vector<std::uint8_t> row = Row(u, 2.0, 40.0, 6.0, 2.0, &rng);
    const ProfileFit fit = FitProfile(row.data(), Start(30.5, 2.2), {4.1, 0.0, 0.0}, {});
    ASSERT_TRUE(fit.ok);
    const double error = fit.u - u, limit = CentreBound(u, 40.0, 2.0, 6.0, 2.0, 6.0);
    square += error * error / kRows;
    normal += error * error / (fit.sd_u * fit.sd_u) / kRows;
    bound += limit * limit / kRows;
  }
  EXPECT_LT(std::sqrt(square / bound), 1.1);
  EXPECT_NEAR(std::sqrt(normal), 1.0, 0.08);
}

TEST(ProfileFit, ClippedTopsAreCompleted) {
  Rng rng(3);
  const std::vector<std::uint8_t> row = Row(29.8, 2.0, 400.0, 5.0, 0.5, &rng);
  const ProfileFit fit = FitProfile(row.data(), Start(30.4, 2.0), {}, {});
  ASSERT_TRUE(fit.ok);
  EXPECT_GT(fit.clipped, 2);
  EXPECT_NEAR(fit.u, 29.8, 0.03);
  EXPECT_NEAR(fit.amplitude, 400.0, 20.0);
}

TEST(ProfileFit, OneFlankIsEnoughWhenTheWidthIsHeld) {
  Rng rng(4);
  const std::vector<std::uint8_t> row = Row(30.3, 2.5, 150.0, 5.0, 0.5, &rng, 30.0);
  ProfileStart start = Start(29.5, 2.5);
  start.last = 29;
  start.hold_width = true;
  const ProfileFit fit = FitProfile(row.data(), start, {}, {});
  ASSERT_TRUE(fit.ok);
  EXPECT_NEAR(fit.u, 30.3, 0.25);
  EXPECT_LT(std::abs(fit.u - 30.3), 5.0 * fit.sd_u);
}

TEST(ProfileFit, TheWindowKeepsTheNeighbourOut) {
  Rng rng(5);
  std::vector<std::uint8_t> row = Row(25.2, 2.0, 60.0, 5.0, 0.0, &rng);
  const std::vector<std::uint8_t> bright = Row(34.0, 2.0, 200.0, 0.0, 0.0, &rng);
  for (std::size_t x = 0; x < row.size(); ++x) row[x] = static_cast<std::uint8_t>(row[x] + bright[x]);
  ProfileStart start = Start(25.0, 2.0);
  start.last = 29;
  const ProfileFit fit = FitProfile(row.data(), start, {}, {});
  ASSERT_TRUE(fit.ok);
  EXPECT_LE(fit.last, 29);
  EXPECT_NEAR(fit.u, 25.2, 0.1);
}

TEST(ProfileFit, AnEmptyWindowIsRefused) {
  const std::vector<std::uint8_t> flat(61, 10);
  ProfileStart start = Start(30.0, 2.0);
  start.first = start.last = 30;
  EXPECT_FALSE(FitProfile(flat.data(), start, {}, {}).ok);
}

TEST(ProfileFit, TheGainOfTheSurfaceDoesNotPullTheCentre) {
  Rng rng(5);
  std::vector<float> gain;
  std::vector<std::uint8_t> row = Row(30.3, 2.5, 150.0, 8.0, 0.0, &rng);
  for (int x = 0; x <= 60; ++x) {
    gain.push_back(static_cast<float>(std::exp(-0.08 * (x - 30.3))));
    row[static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(
        std::lround(std::min(255.0F, static_cast<float>(row[static_cast<std::size_t>(x)]) * gain.back())));
  }
  ProfileStart start = Start(30.0, 2.2);
  EXPECT_NEAR(FitProfile(row.data(), start, {}, {}).u, 30.3 - 0.08 * 2.5 * 2.5, 0.1);
  start.gain = gain.data();
  EXPECT_NEAR(FitProfile(row.data(), start, {}, {}).u, 30.3, 0.02);
}

TEST(ProfileFit, ColumnsWithoutGainDoNotCount) {
  Rng rng(6);
  std::vector<std::uint8_t> row = Row(30.3, 2.5, 150.0, 8.0, 0.0, &rng);
  std::vector<float> gain(61, 1.0F);
  for (std::size_t x = 31; x < 61; ++x) {
    row[x] = 200;  // something else
    gain[x] = 0.0F;
  }
  ProfileStart start = Start(29.5, 2.5);
  start.hold_width = true;
  start.gain = gain.data();
  const ProfileFit fit = FitProfile(row.data(), start, {}, {});
  ASSERT_TRUE(fit.ok);
  EXPECT_NEAR(fit.u, 30.3, 0.05);
  std::fill(gain.begin(), gain.end(), 0.0F);
  EXPECT_FALSE(FitProfile(row.data(), start, {}, {}).ok);
}

// Wide, narrow, clipped, cut and hopeless rows beside each other, more than there are lanes.
TEST(ProfileFit, IsTheSameWhateverIsFittedBesideIt) {
  Rng rng(7);
  std::vector<std::vector<std::uint8_t>> rows;
  std::vector<ProfileTask> tasks;
  for (int i = 0; i < 53; ++i) {
    const double width = 0.8 + 0.13 * i, amplitude = i % 9 == 0 ? 1.0 : 20.0 + 11.0 * i;
    rows.push_back(Row(30.0 + 0.1 * (i % 7), width, amplitude, 5.0, 1.5, &rng, i % 5 == 0 ? 31.0 : 1e9));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ProfileStart start = Start(30.4, i % 2 == 0 ? 2.0 : 4.0);
    start.hold_width = i % 5 == 0;
    if (i % 11 == 0) start.first = 29;
    if (i == 20) start.last = 3;
    tasks.push_back({rows[i].data(), start});
  }
  const NoiseModel noise{2.0, 0.05, 0.0};
  const std::vector<ProfileFit> together = FitProfiles(tasks, noise, {});
  int good = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const ProfileFit alone = FitProfile(tasks[i].row, tasks[i].start, noise, {});
    EXPECT_EQ(together[i].ok, alone.ok) << i;
    EXPECT_EQ(together[i].width_held, alone.width_held) << i;
    if (!alone.ok) continue;
    ++good;
    EXPECT_EQ(together[i].u, alone.u) << i;
    EXPECT_EQ(together[i].width, alone.width) << i;
    EXPECT_EQ(together[i].sd_u, alone.sd_u) << i;
  }
  EXPECT_GT(good, 40);
  EXPECT_FALSE(together[20].ok);
  EXPECT_TRUE(FitProfiles({}, noise, {}).empty());
}

}  // namespace
}  // namespace dorsum
