// SPDX-License-Identifier: Apache-2.0
#include "geometry/diffraction.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/light_sheet.h"

namespace dorsum {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = kPi / 4.0;

// Worked by hand: 100 lines/mm and 532 nm give lambda / d = 0.0532.
TEST(Diffraction, TheGratingEquationsByHand) {
  const SlitGrating grating{100.0, 532.0, 0.0};
  EXPECT_DOUBLE_EQ(grating.PeriodUm(), 10.0);
  EXPECT_NEAR(grating.SineOfOrder(), 0.0532, 1e-15);
  EXPECT_NEAR(*OrderAngle(grating, 1) * 180.0 / kPi, 3.0496, 1e-4);
  EXPECT_NEAR(*OrderAngle(grating, 10) * 180.0 / kPi, 32.1400, 1e-3);
  EXPECT_EQ(HighestOrder(grating), 18);  // 18 * 0.0532 = 0.958, 19 * 0.0532 = 1.011
  EXPECT_TRUE(OrderAngle(grating, -18));
  EXPECT_FALSE(OrderAngle(grating, 19));
  EXPECT_NEAR(*OrderSpacing(grating, 395.0), 395.0 * 0.0532 / std::sqrt(1.0 - 0.0532 * 0.0532), 1e-12);
  EXPECT_NEAR(SlitGrating({100.0, 532.0, kTurn}).Step(), 0.0532 * std::sqrt(0.5), 1e-15);
}

// DESIGN §2: 1000 lines/mm put the next order over 150 mm away at 400 mm, turned or not.
TEST(Diffraction, AThousandLinesPutTheNextStripeFarOutside) {
  EXPECT_NEAR(*OrderSpacing({1000.0, 532.0, 0.0}, 400.0), 251.31, 0.01);
  EXPECT_NEAR(*OrderSpacing({1000.0, 532.0, kTurn}, 400.0), 162.41, 0.01);
  EXPECT_EQ(HighestOrder({1000.0, 532.0, 0.0}), 1);
  EXPECT_EQ(HighestOrder({2000.0, 532.0, 0.0}), 0);
}

TEST(Diffraction, OneSlitIsBrightInItsMiddleAndDarkAtWholeWavelengths) {
  EXPECT_DOUBLE_EQ(SlitIntensity(0.0), 1.0);
  EXPECT_NEAR(SlitIntensity(kPi / 2.0), 4.0 / (kPi * kPi), 1e-15);
  // a sin(phi) = lambda: the first dark place.
  const double phi = std::asin(0.532 / 2.0);
  EXPECT_NEAR(SlitPhase(2.0, 532.0, phi), kPi, 1e-12);
  EXPECT_NEAR(SlitIntensity(SlitPhase(2.0, 532.0, phi)), 0.0, 1e-30);
  // The document's a = lambda: no dark place before 90 degrees.
  EXPECT_NEAR(SlitPhase(0.532, 532.0, kPi / 2.0), kPi, 1e-12);
}

TEST(Diffraction, TwoSlitsAreTheGratingOfTwo) {
  for (const double phi : {0.0, 0.01, 0.1, 0.37, 0.9}) {
    const double alpha = SlitPhase(3.0, 532.0, phi), beta = InterferencePhase(10.0, 532.0, phi);
    EXPECT_NEAR(GratingIntensity(alpha, beta, 2), DoubleSlitIntensity(alpha, beta), 1e-12) << phi;
  }
}

// Maxima of 2.4 and of N slits lie where 2.6 has them, as bright as the envelope.
TEST(Diffraction, OrdersStandWhereAllSlitsAreInPhase) {
  const SlitGrating grating{100.0, 532.0, 0.0};
  for (const int m : {-7, -1, 0, 3, 12}) {
    const double phi = *OrderAngle(grating, m);
    const double alpha = SlitPhase(2.5, 532.0, phi), beta = InterferencePhase(10.0, 532.0, phi);
    EXPECT_NEAR(beta, m * kPi, 1e-9);
    EXPECT_NEAR(GratingIntensity(alpha, beta, 50), RelativeOrderIntensity(grating, 2.5, m), 1e-9) << m;
    EXPECT_NEAR(DoubleSlitIntensity(alpha, beta), RelativeOrderIntensity(grating, 2.5, m), 1e-9) << m;
  }
}

TEST(Diffraction, ThePeakOfManySlitsHasTheStatedWidth) {
  const SlitGrating grating{100.0, 532.0, 0.0};
  const double sigma = PeakSigma(grating, 1.0);  // 100 slits
  const double beta = kPi * 0.1 * sigma / grating.SineOfOrder();
  EXPECT_NEAR(GratingIntensity(0.0, beta, 100), std::exp(-0.5 * 0.01), 1e-5);
  EXPECT_LT(sigma, 0.9e-3 / 4.0) << "narrower than the laser line that it widens";
}

// Parseval: the orders together carry what the slits let through.
TEST(Diffraction, AllOrdersTogetherCarryWhatTheSlitsLetThrough) {
  const SlitGrating grating{100.0, 532.0, 0.0};
  for (const double slit : {0.5, 2.5, 5.0, 9.0}) {
    double sum = 0.0;
    for (int m = -200000; m <= 200000; ++m) sum += OrderEfficiency(grating, slit, m);
    EXPECT_NEAR(sum, slit / 10.0, 1e-5) << slit;
  }
}

TEST(Diffraction, SlitsForEvenAndForBrightOrders) {
  const SlitGrating grating{100.0, 532.0, kTurn};
  const double even = SlitForEvenness(grating, 10, 0.5);
  EXPECT_NEAR(RelativeOrderIntensity(grating, even, 10), 0.5, 1e-9);
  EXPECT_GT(RelativeOrderIntensity(grating, even, 9), 0.5);
  // The document's advice, a = lambda, is even to 90 degrees but for nothing: at sin(phi) = 1 it is dark.
  EXPECT_NEAR(RelativeOrderIntensity({100.0, 500.0, 0.0}, 0.5, 20), 0.0, 1e-12);
  const double bright = SlitForBrightestOrder(grating, 10);
  EXPECT_NEAR(bright, 0.5, 1e-12);
  const double most = OrderEfficiency(grating, bright, 10);
  EXPECT_GT(most, OrderEfficiency(grating, 0.99 * bright, 10));
  EXPECT_GT(most, OrderEfficiency(grating, 1.01 * bright, 10));
  EXPECT_NEAR(RelativeOrderIntensity(grating, bright, 10), 4.0 / (kPi * kPi), 1e-12);
}

// The document's plane through the grating and the order's stripe agrees at the middle only; off it the cone
// bends the stripe.
TEST(Diffraction, PositionsAreThoseOfTheCone) {
  const SlitGrating grating{100.0, 532.0, kTurn};
  DiffractedFan fan;
  fan.origin = {0.0, 0.0, 395.0};
  fan.step = grating.Step();
  for (const int m : {-9, -1, 0, 4, 10}) {
    for (const double beta : {0.0, 0.2, -0.35}) {
      const auto ray = DiffractedRay(fan, m, beta);
      const auto t = Intersect(*ray, {Eigen::Vector3d::UnitZ(), 40.0});
      EXPECT_NEAR(ray->At(*t).x(), *OrderPosition(grating, m, 355.0, beta), 1e-9) << m << " " << beta;
    }
  }
  EXPECT_GT(*OrderPosition(grating, 10, 395.0, 0.35), *OrderPosition(grating, 10, 395.0) + 10.0);
  EXPECT_FALSE(OrderPosition(grating, 25, 395.0, 0.4));
}

TEST(Diffraction, CrossedGratingsAt45DegreesShareTheirSheets) {
  const SlitGrating grating{100.0, 532.0, kTurn};
  const auto orders = CrossedOrders(grating, 2.5, 6);
  EXPECT_EQ(orders.size(), 169U);
  for (const CrossedOrder& o : orders) {
    EXPECT_NEAR(o.alpha, (o.p - o.q) * grating.Step(), 1e-12);
    EXPECT_NEAR(o.along, (o.p + o.q) * grating.Step(), 1e-12);
  }
  // At another turn the orders of one p - q fall apart.
  double spread = 0.0;
  for (const CrossedOrder& o : CrossedOrders({100.0, 532.0, 0.5}, 2.5, 6)) {
    if (o.p - o.q == 1) spread = std::max(spread, std::abs(o.alpha - 0.0532 * std::cos(0.5)));
  }
  EXPECT_GT(spread, 0.05);
  // In the middle all of a sheet's orders whose fans reach there add up: with a wide fan the whole row.
  double row = 0.0;
  for (int p = -6; p <= 6; ++p) row += OrderEfficiency(grating, 2.5, p) * OrderEfficiency(grating, 2.5, p);
  EXPECT_NEAR(CrossedSheetEfficiency(orders, 0, 0.0, 10.0), row, 1e-12);
  EXPECT_NEAR(CrossedSheetEfficiency(orders, 0, 0.0, 1e-6), std::pow(0.25, 4), 1e-12);
  EXPECT_EQ(CrossedSheetEfficiency(orders, 0, 3.0, 0.3), 0.0);
}

}  // namespace
}  // namespace dorsum
