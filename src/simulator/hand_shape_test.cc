// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_shape.h"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace dorsum {
namespace {

constexpr int kPeople = 4000;

std::vector<HandShape> People(Sex sex, int count = kPeople) {
  std::vector<HandShape> people;
  Rng rng(NamedSeed("population"));
  people.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) people.push_back(SampleHandShape(sex, rng));
  return people;
}

using Measure = std::function<double(const HandShape&)>;

struct Moments {
  double mean = 0, sd = 0;
};

Moments MomentsOf(const std::vector<HandShape>& people, const Measure& measure) {
  double sum = 0, squares = 0;
  for (const HandShape& person : people) sum += measure(person);
  const double mean = sum / people.size();
  for (const HandShape& person : people) squares += std::pow(measure(person) - mean, 2);
  return {mean, std::sqrt(squares / (people.size() - 1))};
}

double Correlation(const std::vector<HandShape>& people, const Measure& a, const Measure& b) {
  const Moments ma = MomentsOf(people, a), mb = MomentsOf(people, b);
  double sum = 0;
  for (const HandShape& person : people) sum += (a(person) - ma.mean) * (b(person) - mb.mean);
  return sum / (people.size() - 1) / (ma.sd * mb.sd);
}

const Measure kLength = [](const HandShape& s) { return s.hand_length; };
const Measure kPalm = [](const HandShape& s) { return s.palm_length; };
const Measure kBreadth = [](const HandShape& s) { return s.hand_breadth; };
const Measure kCircumference = [](const HandShape& s) { return s.hand_circumference; };
const Measure kWristGirth = [](const HandShape& s) { return s.wrist_circumference; };

Measure FingerLength(int i) {
  return [i](const HandShape& s) { return s.fingers[i].length; };
}
Measure FingerBreadth(int i) {
  return [i](const HandShape& s) { return s.fingers[i].pip_breadth; };
}

// Means within 4.5 standard errors; clamping at 2.8 takes about 1.5 % off a standard deviation, and its own
// standard error is 1.1 % for this many people.
void ExpectMoments(const std::vector<HandShape>& people, const Measure& measure, double mean, double sd) {
  const Moments moments = MomentsOf(people, measure);
  EXPECT_NEAR(moments.mean, mean, 4.5 * sd / std::sqrt(people.size()));
  EXPECT_NEAR(moments.sd, sd, 0.06 * sd);
}

TEST(HandShapeTest, MenMatchTheTable) {
  const auto people = People(Sex::kMan);
  ExpectMoments(people, kLength, 193.3, 10.0);
  ExpectMoments(people, kPalm, 116.5, 6.2);
  ExpectMoments(people, kBreadth, 88.3, 4.4);
  ExpectMoments(people, kCircumference, 212.3, 10.2);
  ExpectMoments(people, kWristGirth, 175.9, 9.0);
  ExpectMoments(people, FingerLength(0), 75.8, 4.4);
  ExpectMoments(people, FingerLength(3), 65.2, 4.3);
  ExpectMoments(people, FingerBreadth(1), 22.4, 1.7);
}

TEST(HandShapeTest, WomenMatchTheTable) {
  const auto people = People(Sex::kWoman);
  ExpectMoments(people, kLength, 181.1, 10.1);
  ExpectMoments(people, kBreadth, 78.2, 3.8);
  ExpectMoments(people, FingerLength(2), 74.0, 4.5);
  ExpectMoments(people, FingerBreadth(3), 17.5, 1.2);
  ExpectMoments(
      people, [](const HandShape& s) { return s.thumb.length; }, 64.8, 4.1);
}

TEST(HandShapeTest, DerivedMeasuresAgreeWithOtherSurveys) {
  const auto people = People(Sex::kMan);
  auto mean = [&](const Measure& measure) { return MomentsOf(people, measure).mean; };
  // Greiner's crotch heights and digit 3 links, from hands 1.5 mm longer than ANSUR's.
  const double crotch[] = {69.1, 110.4, 109.9, 96.6};
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(mean([i](const HandShape& s) { return s.crotch_height[i]; }), crotch[i], 1.5);
  EXPECT_NEAR(mean([](const HandShape& s) { return s.fingers[1].proximal_link; }), 54.8, 1.0);
  EXPECT_NEAR(mean([](const HandShape& s) { return s.fingers[1].middle_link; }), 26.4, 1.0);
  EXPECT_NEAR(mean([](const HandShape& s) { return s.fingers[1].distal_link; }), 28.7, 1.0);
  EXPECT_NEAR(mean([](const HandShape& s) { return s.hand_breadth_open; }), 97.2, 0.5);
  EXPECT_NEAR(mean([](const HandShape& s) { return s.fingers[0].pip_depth; }), 20.8, 0.3);
  EXPECT_NEAR(mean([](const HandShape& s) { return s.wrist_breadth; }), 65.8, 0.5);
}

TEST(HandShapeTest, CorrelationsFollowTheTable) {
  for (Sex sex : {Sex::kMan, Sex::kWoman}) {
    const auto people = People(sex);
    EXPECT_NEAR(Correlation(people, kLength, kPalm), 0.80, 0.05);
    EXPECT_NEAR(Correlation(people, kLength, kBreadth), 0.575, 0.05);
    EXPECT_NEAR(Correlation(people, kLength, kCircumference), 0.575, 0.06);
    EXPECT_NEAR(Correlation(people, kBreadth, kCircumference), 0.905, 0.03);
    EXPECT_NEAR(Correlation(people, kCircumference, kWristGirth), 0.755, 0.05);
    EXPECT_NEAR(Correlation(people, kLength, kWristGirth), 0.54, 0.06);
    EXPECT_NEAR(Correlation(people, FingerLength(0), FingerLength(2)), 0.85, 0.04);
    EXPECT_NEAR(Correlation(people, FingerBreadth(0), FingerBreadth(2)), 0.75, 0.05);
    EXPECT_NEAR(Correlation(people, FingerLength(0), FingerBreadth(0)), 0.42, 0.06);
    EXPECT_NEAR(Correlation(people, kPalm, FingerLength(1)), 0.59, 0.08);
  }
}

TEST(HandShapeTest, EveryHandIsPlausible) {
  for (Sex sex : {Sex::kMan, Sex::kWoman}) {
    for (const HandShape& s : People(sex, 1000)) {
      EXPECT_GT(s.crotch_height[1], s.crotch_height[3]);
      EXPECT_GT(s.crotch_height[3], s.crotch_height[0]);
      EXPECT_GT(s.WristDepth(), 0.40 * s.wrist_breadth);
      EXPECT_LT(s.WristDepth(), 0.95 * s.wrist_breadth);
      for (const FingerShape& f : s.fingers) {
        EXPECT_GT(f.proximal_link + f.middle_link + f.distal_link, f.length + 10);
        EXPECT_LT(f.dip_breadth, f.pip_breadth);
        EXPECT_GT(f.dip_depth, 0.6 * f.dip_breadth);
        EXPECT_LT(f.nail_length, 0.75 * f.distal_link);
      }
    }
  }
}

TEST(HandShapeTest, SessionsChangeGirthMoreThanLength) {
  const HandShape person = People(Sex::kWoman, 1)[0];
  Rng rng(5);
  std::vector<HandShape> visits;
  visits.reserve(2000);
  for (int i = 0; i < 2000; ++i) visits.push_back(VaryForSession(person, rng));
  const Moments length = MomentsOf(visits, FingerLength(1)), breadth = MomentsOf(visits, FingerBreadth(1));
  EXPECT_NEAR(length.mean, person.fingers[1].length, 0.02);
  EXPECT_NEAR(length.sd / length.mean, 0.003, 0.0004);
  EXPECT_NEAR(breadth.sd / breadth.mean, std::hypot(0.0125, 0.005), 0.001);
  EXPECT_GT(Correlation(visits, FingerBreadth(0), FingerBreadth(3)), 0.75);
  for (const HandShape& visit : visits) {
    EXPECT_EQ(visit.detail.seed, person.detail.seed);
    EXPECT_NEAR(visit.hand_length, person.hand_length, 0.015 * person.hand_length);
  }
}

TEST(HandShapeTest, SameSeedSamePerson) {
  const HandShape a = People(Sex::kMan, 3)[2], b = People(Sex::kMan, 3)[2], other = People(Sex::kMan, 2)[1];
  EXPECT_EQ(a.hand_length, b.hand_length);
  EXPECT_EQ(a.fingers[3].nail_breadth, b.fingers[3].nail_breadth);
  EXPECT_EQ(a.detail.seed, b.detail.seed);
  EXPECT_NE(a.detail.seed, other.detail.seed);
}

}  // namespace
}  // namespace dorsum
