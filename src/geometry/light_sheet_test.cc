// SPDX-License-Identifier: Apache-2.0
#include "geometry/light_sheet.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

DiffractedFan Fan(FanForm form, double tilt) {
  DiffractedFan fan;
  fan.origin = {3.0, -1.0, 395.0};
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.02, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  fan.a = turn * Eigen::Vector3d::UnitX();
  fan.b = turn * -Eigen::Vector3d::UnitY();
  fan.n = turn * -Eigen::Vector3d::UnitZ();
  fan.fan_distance_mm = 15.0;
  fan.tilt = tilt;
  fan.step = 0.0376;
  fan.form = form;
  return fan;
}

TEST(LightSheet, LocateFindsTheRayThatDiffractedRayMade) {
  for (const FanForm form : {FanForm::kFlat, FanForm::kConical}) {
    for (const double tilt : {0.0, 0.01, -0.2}) {
      const DiffractedFan fan = Fan(form, tilt);
      for (int m = -10; m <= 10; ++m) {
        for (const double beta : {-0.4, -0.1, 0.0, 0.3}) {
          for (const double distance : {120.0, 310.0, 500.0}) {
            const auto ray = DiffractedRay(fan, m, beta);
            ASSERT_TRUE(ray.has_value());
            EXPECT_NEAR(ray->direction.norm(), 1.0, 1e-14);
            const auto at = Locate(fan, ray->At(distance));
            ASSERT_TRUE(at.has_value());
            EXPECT_NEAR(at->Order(fan), m, 1e-9);
            EXPECT_NEAR(at->beta, beta, 1e-11);
            EXPECT_NEAR(at->distance_mm, distance, 1e-8);
            EXPECT_LT((at->exit - ray->origin).norm(), 1e-8);
          }
        }
      }
    }
  }
}

TEST(LightSheet, LocateFindsTheRaysOfATurnedAndBowedFan) {
  for (const double bow : {-0.05, 0.0, 0.08}) {
    DiffractedFan fan = Fan(FanForm::kGeneral, 0.06);
    fan.bow = bow;
    fan.turn = 0.03;
    for (const int m : {-10, -1, 0, 7}) {
      for (const double beta : {-0.38, 0.0, 0.25}) {
        const auto ray = DiffractedRay(fan, m, beta);
        ASSERT_TRUE(ray.has_value());
        const auto at = Locate(fan, ray->At(410.0));
        ASSERT_TRUE(at.has_value());
        EXPECT_NEAR(at->Order(fan), m, 1e-9);
        EXPECT_NEAR(at->beta, beta, 1e-11);
        EXPECT_LT((at->exit - ray->origin).norm(), 1e-8);
      }
    }
  }
}

TEST(LightSheet, TheGeneralFormHoldsThePlainOnes) {
  for (const FanForm form : {FanForm::kFlat, FanForm::kConical}) {
    const DiffractedFan plain = Fan(form, 0.1);
    DiffractedFan general = plain;
    general.bow = EffectiveBow(plain);
    general.form = FanForm::kGeneral;
    for (const double beta : {-0.4, 0.0, 0.3})
      EXPECT_EQ(IncomingAlpha(general, beta), IncomingAlpha(plain, beta));
    EXPECT_EQ(EffectiveBow(plain), form == FanForm::kFlat ? std::sin(0.1) : 0.0);
  }
}

// A fan's plane that is turned about the grating's normal meets the grating in a turned line.
TEST(LightSheet, ATurnedFlatFanIsAPlaneToo) {
  DiffractedFan fan = Fan(FanForm::kFlat, 0.0);
  fan.turn = 0.05;
  const Eigen::Vector3d normal = (fan.a - fan.turn * fan.b).normalized();
  for (const double beta : {-0.35, -0.1, 0.2, 0.35}) {
    const auto ray = DiffractedRay(fan, 0, beta);
    ASSERT_TRUE(ray.has_value());
    EXPECT_NEAR(normal.dot(ray->direction), 0.0, 1e-14);
    EXPECT_NEAR(normal.dot(ray->origin - fan.origin), 0.0, 1e-12);
  }
}

// A laser's fan is a plane of rays from one point; the grating adds m * step to one direction cosine and
// keeps the other. Traced here ray by ray, without the closed forms of the code.
TEST(LightSheet, FlatFanIsAPlaneOfRaysFromOnePoint) {
  const DiffractedFan fan = Fan(FanForm::kFlat, 0.15);
  const Eigen::Vector3d middle = std::sin(fan.tilt) * fan.a + std::cos(fan.tilt) * fan.n;
  const Eigen::Vector3d laser = fan.origin - fan.fan_distance_mm / middle.dot(fan.n) * middle;
  for (const double angle : {-0.38, -0.1, 0.0, 0.2, 0.38}) {
    const Eigen::Vector3d in = std::cos(angle) * middle + std::sin(angle) * fan.b;
    const Eigen::Vector3d exit = laser + fan.fan_distance_mm / in.dot(fan.n) * in;
    for (const int m : {-8, 0, 5}) {
      const auto ray = DiffractedRay(fan, m, in.dot(fan.b));
      ASSERT_TRUE(ray.has_value());
      EXPECT_LT((ray->origin - exit).norm(), 1e-10);
      EXPECT_NEAR(ray->direction.dot(fan.a), in.dot(fan.a) + m * fan.step, 1e-14);
      EXPECT_NEAR(ray->direction.dot(fan.b), in.dot(fan.b), 1e-14);
      EXPECT_GT(ray->direction.dot(fan.n), 0.0);
    }
  }
}

TEST(LightSheet, CentralOrderOfAFlatFanStaysInThePlaneOfTheFan) {
  const DiffractedFan fan = Fan(FanForm::kFlat, 0.1);
  const Eigen::Vector3d normal = std::cos(fan.tilt) * fan.a - std::sin(fan.tilt) * fan.n;
  for (const double beta : {-0.4, -0.2, 0.1, 0.35}) {
    const auto ray = DiffractedRay(fan, 0, beta);
    ASSERT_TRUE(ray.has_value());
    EXPECT_NEAR(normal.dot(ray->At(400.0) - fan.origin), 0.0, 1e-10);
  }
}

TEST(LightSheet, SpacingOnAScreenIsThatOfTheGratingEquation) {
  DiffractedFan fan;  // looks straight down from the origin
  fan.step = 532e-6 * 100.0;
  for (const int m : {1, 4, 9}) {
    const auto ray = DiffractedRay(fan, m, 0.0);
    ASSERT_TRUE(ray.has_value());
    const double x = ray->At(400.0 / -ray->direction.z()).x();
    EXPECT_NEAR(x, 400.0 * std::tan(std::asin(m * fan.step)), 1e-9);  // sin(phi) = m lambda / d (2.5)
  }
}

TEST(LightSheet, NothingLiesBehindTheGratingOrBeyondTheHorizon) {
  const DiffractedFan fan = Fan(FanForm::kFlat, 0.0);
  EXPECT_FALSE(Locate(fan, fan.origin - 5.0 * fan.n).has_value());
  DiffractedFan coarse = fan;
  coarse.step = 0.3;
  EXPECT_TRUE(DiffractedRay(coarse, 3, 0.0).has_value());
  EXPECT_FALSE(DiffractedRay(coarse, 4, 0.0).has_value());
  EXPECT_FALSE(DiffractedRay(coarse, 3, 0.5).has_value());
}

}  // namespace
}  // namespace dorsum
