// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace dorsum {

// Diffraction of the document's §2.5 (equations 2.2 to 2.7), and what the three-dimensional case adds to it
// (DESIGN §3). Angles in radians, wavelengths in nm, slits and periods in um, gratings in lines/mm. The
// document's equations are of scalar far-field theory, for light that meets the slits head-on; slits about as
// narrow as the wavelength depart from it. Arguments must be finite; lengths above zero.

// A transmission grating of even slits. Its period d is 1000 / lines_per_mm um.
struct SlitGrating {
  double lines_per_mm = 100.0;
  double wavelength_nm = 532.0;
  double turn_rad = 0.0;  // of the grating about its normal: 0 spreads the orders along the baseline

  double PeriodUm() const;     // d = 1 / N (2.7)
  double SineOfOrder() const;  // lambda / d: what each order adds to sin(phi) in the grating's own axis (2.6)
  double Step() const;         // lambda / d * cos(turn): the same along the baseline (DESIGN §3)
  double AlongStripe() const;  // lambda / d * sin(turn): along the stripe
};

// Equation 2.3: alpha = pi a / lambda * sin(phi).
double SlitPhase(double slit_um, double wavelength_nm, double phi);
// Equation 2.2 over I_max: (sin(alpha) / alpha)^2, 1 at alpha = 0.
double SlitIntensity(double alpha);
// Equation 2.5: beta = pi d / lambda * sin(phi).
double InterferencePhase(double period_um, double wavelength_nm, double phi);
// Equation 2.4 over I_max: cos(beta)^2 times that of one slit. (The text below 2.4 calls the first factor
// "cos(2 beta)"; the equation is right.)
double DoubleSlitIntensity(double alpha, double beta);
// N slits instead of two: (sin(N beta) / (N sin(beta)))^2 times that of one slit; 2.4 for N = 2.
double GratingIntensity(double alpha, double beta, int slits);

// Equation 2.6: the angle of order m, sin(phi) = m lambda / d (times cos(turn)); none where it does not
// exist.
std::optional<double> OrderAngle(const SlitGrating& grating, int order);
// The highest order that exists: |m| lambda / d < 1.
int HighestOrder(const SlitGrating& grating);
// Half width (one standard deviation of the Gaussian with the same curvature at its top) of an order's peak
// in direction cosine, when the beam lights `beam_mm` of the grating: what N slits leave of 2.4's broad
// fringes.
double PeakSigma(const SlitGrating& grating, double beam_mm);

// Brightness of order m over that of the central one: 2.2 at the angles of 2.6, sinc(m a / d)^2.
double RelativeOrderIntensity(const SlitGrating& grating, double slit_um, int order);
// Share of the light on the grating that order m carries: (a / d)^2 sinc(m a / d)^2. Over all whole numbers
// these sum to a / d, the share that the slits let through (Parseval).
double OrderEfficiency(const SlitGrating& grating, double slit_um, int order);
// The widest slit whose orders up to `order` keep at least `share` (0 to 1) of the central one's brightness.
// The document's a = lambda is the case that lasts to 90 degrees.
double SlitForEvenness(const SlitGrating& grating, int order, double share);
// The slit that sends most light into `order`: a = d / (2 m). That order is then (2 / pi)^2 = 0.41 of the
// central one.
double SlitForBrightestOrder(const SlitGrating& grating, int order);

// Where order m meets a plane `height_mm` below the grating, from the central one: h tan(phi). `beta` is the
// direction cosine along the stripe: the sheet is a cone, so the stripe bends outwards (a hyperbola) by
// h alpha / sqrt(1 - alpha^2 - beta^2). None where no light goes.
std::optional<double> OrderPosition(const SlitGrating& grating, int order, double height_mm,
                                    double beta = 0.0);
// From the central stripe to the first.
std::optional<double> OrderSpacing(const SlitGrating& grating, double height_mm);

// Order (p, q) of two crossed gratings of the same period, the first turned by turn_rad, the second by 90
// degrees more.
struct CrossedOrder {
  int p = 0, q = 0;
  double alpha = 0.0;       // added to the direction cosine along the baseline
  double along = 0.0;       // added along the stripe
  double efficiency = 0.0;  // of both gratings one after the other
};

// All of |p|, |q| <= `most` that exist. At a turn of 45 degrees alpha is (p - q) lambda / (d sqrt 2), so all
// with the same p - q lie on the same sheets; at other turns they fall apart into many combs.
std::vector<CrossedOrder> CrossedOrders(const SlitGrating& grating, double slit_um, int most);

// Light of the sheet p - q = order at direction cosine `beta` along the stripe (45 degrees), as a share of
// what falls on the grating in a fan from -half_opening to half_opening in beta: the sum over (p, q) whose
// shifted fan reaches there.
double CrossedSheetEfficiency(const std::vector<CrossedOrder>& orders, int order, double beta,
                              double half_opening);

}  // namespace dorsum
