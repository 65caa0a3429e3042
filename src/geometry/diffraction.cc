// SPDX-License-Identifier: Apache-2.0
#include "geometry/diffraction.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace dorsum {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kUmPerMm = 1e3, kNmPerUm = 1e3;

}  // namespace

double SlitGrating::PeriodUm() const { return kUmPerMm / lines_per_mm; }
double SlitGrating::SineOfOrder() const { return wavelength_nm / kNmPerUm / PeriodUm(); }
double SlitGrating::Step() const { return SineOfOrder() * std::cos(turn_rad); }
double SlitGrating::AlongStripe() const { return SineOfOrder() * std::sin(turn_rad); }

double SlitPhase(double slit_um, double wavelength_nm, double phi) {
  return kPi * slit_um * kNmPerUm / wavelength_nm * std::sin(phi);
}

double SlitIntensity(double alpha) {
  if (std::abs(alpha) < 1e-8) return 1.0;
  const double sinc = std::sin(alpha) / alpha;
  return sinc * sinc;
}

double InterferencePhase(double period_um, double wavelength_nm, double phi) {
  return kPi * period_um * kNmPerUm / wavelength_nm * std::sin(phi);
}

double DoubleSlitIntensity(double alpha, double beta) {
  return std::cos(beta) * std::cos(beta) * SlitIntensity(alpha);
}

double GratingIntensity(double alpha, double beta, int slits) {
  const double sine = std::sin(beta);
  // In the middle of an order both sines vanish, and their ratio is 1.
  const double ratio = std::abs(sine) < 1e-9 ? 1.0 : std::sin(slits * beta) / (slits * sine);
  return ratio * ratio * SlitIntensity(alpha);
}

std::optional<double> OrderAngle(const SlitGrating& grating, int order) {
  if (std::abs(order) > HighestOrder(grating)) return std::nullopt;
  return std::asin(order * grating.Step());
}

int HighestOrder(const SlitGrating& grating) {
  const double sine = grating.SineOfOrder();
  return static_cast<int>(std::min(1e6, std::ceil(1.0 / sine) - 1.0));
}

double PeakSigma(const SlitGrating& grating, double beam_mm) {
  // (sin(N b) / (N sin b))^2 falls like 1 - (N^2 - 1) b^2 / 3 about b = 0, with b = pi d alpha / lambda.
  const double slits = std::max(2.0, beam_mm * grating.lines_per_mm);
  const double sigma_phase = std::sqrt(1.5 / (slits * slits - 1.0));
  return sigma_phase * grating.SineOfOrder() / kPi;
}

double RelativeOrderIntensity(const SlitGrating& grating, double slit_um, int order) {
  return SlitIntensity(kPi * order * slit_um / grating.PeriodUm());
}

double OrderEfficiency(const SlitGrating& grating, double slit_um, int order) {
  const double open = slit_um / grating.PeriodUm();
  return open * open * RelativeOrderIntensity(grating, slit_um, order);
}

double SlitForEvenness(const SlitGrating& grating, int order, double share) {
  // sinc falls without a turn from 1 to 0 while its argument grows to pi.
  double low = 0.0, high = kPi;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (SlitIntensity(middle) >= share ? low : high) = middle;
  }
  return std::min(1.0, low / (kPi * std::max(1, std::abs(order)))) * grating.PeriodUm();
}

double SlitForBrightestOrder(const SlitGrating& grating, int order) {
  return grating.PeriodUm() / (2.0 * std::max(1, std::abs(order)));
}

std::optional<double> OrderPosition(const SlitGrating& grating, int order, double height_mm, double beta) {
  const double alpha = order * grating.Step();
  const double gamma_squared = 1.0 - alpha * alpha - beta * beta;
  if (gamma_squared <= 0.0) return std::nullopt;
  return height_mm * alpha / std::sqrt(gamma_squared);
}

std::optional<double> OrderSpacing(const SlitGrating& grating, double height_mm) {
  return OrderPosition(grating, 1, height_mm);
}

std::vector<CrossedOrder> CrossedOrders(const SlitGrating& grating, double slit_um, int most) {
  std::vector<CrossedOrder> orders;
  for (int p = -most; p <= most; ++p) {
    for (int q = -most; q <= most; ++q) {
      CrossedOrder order{p, q};
      order.alpha = p * grating.Step() - q * grating.AlongStripe();
      order.along = p * grating.AlongStripe() + q * grating.Step();
      if (order.alpha * order.alpha + order.along * order.along >= 1.0) continue;
      order.efficiency = OrderEfficiency(grating, slit_um, p) * OrderEfficiency(grating, slit_um, q);
      orders.push_back(order);
    }
  }
  return orders;
}

double CrossedSheetEfficiency(const std::vector<CrossedOrder>& orders, int order, double beta,
                              double half_opening) {
  double sum = 0.0;
  for (const CrossedOrder& o : orders) {
    if (o.p - o.q == order && std::abs(beta - o.along) <= half_opening) sum += o.efficiency;
  }
  return sum;
}

}  // namespace dorsum
