// SPDX-License-Identifier: Apache-2.0
#include "geometry/light_sheet.h"

#include <cmath>

namespace dorsum {

double EffectiveBow(const DiffractedFan& fan) {
  switch (fan.form) {
    case FanForm::kFlat:
      return std::sin(fan.tilt);
    case FanForm::kConical:
      return 0.0;
    case FanForm::kGeneral:
      return fan.bow;
  }
  return 0.0;
}

namespace {

// What a fan asks for again and again.
struct FanShape {
  explicit FanShape(const DiffractedFan& f)
      : fan(f), sin_tilt(std::sin(f.tilt)), bow(f.form == FanForm::kFlat ? sin_tilt : EffectiveBow(f)) {}

  double IncomingAlpha(double beta) const {
    return sin_tilt + fan.turn * beta + bow * (std::sqrt(1.0 - beta * beta) - 1.0);
  }
  // Where on the grating's b axis the ray with direction cosine beta arrives.
  double ExitOffset(double beta) const {
    const double alpha = IncomingAlpha(beta);
    return fan.fan_distance_mm * beta / std::sqrt(1.0 - alpha * alpha - beta * beta);
  }

  const DiffractedFan& fan;
  double sin_tilt, bow;
};

}  // namespace

double IncomingAlpha(const DiffractedFan& fan, double beta) { return FanShape(fan).IncomingAlpha(beta); }

std::optional<FanCoordinates> Locate(const DiffractedFan& fan, const Eigen::Vector3d& world) {
  const FanShape shape(fan);
  const Eigen::Vector3d d = world - fan.origin;
  const double x = fan.a.dot(d), y = fan.b.dot(d), z = fan.n.dot(d);
  if (z <= 0.0) return std::nullopt;
  // Solves y_g = ExitOffset((y - y_g) / |(x - turn y_g, y - y_g, z)|). The fan starts close behind the
  // grating compared with the point's distance, so the right side hardly depends on y_g, and secants meet at
  // once. It begins with the answer for a fan without tilt, whose light spreads over y from a point
  // fan_distance behind (0, 0, 0).
  FanCoordinates c;
  double y_g = y * fan.fan_distance_mm / (std::sqrt(x * x + z * z) + fan.fan_distance_mm);
  double last_y_g = 0.0, last_miss = 0.0;
  constexpr double kEnoughMm = 1e-13;
  for (int i = 0; i < 60; ++i) {
    const double dx = x - fan.turn * y_g, dy = y - y_g;
    c.distance_mm = std::sqrt(dx * dx + dy * dy + z * z);
    c.beta = dy / c.distance_mm;
    const double miss = shape.ExitOffset(c.beta) - y_g;
    if (!(std::abs(miss) > kEnoughMm)) break;
    const double change = miss - last_miss, away = y_g - last_y_g;
    const bool secant = i > 0 && std::abs(change) > 0.5 * std::abs(away);  // about -1.04 of it
    last_y_g = y_g;
    last_miss = miss;
    y_g += secant ? -miss * away / change : miss;
  }
  c.alpha = (x - fan.turn * y_g) / c.distance_mm;
  c.alpha_in = shape.IncomingAlpha(c.beta);
  c.exit = fan.origin + y_g * (fan.turn * fan.a + fan.b);
  return c;
}

std::optional<Ray> DiffractedRay(const DiffractedFan& fan, int order, double beta) {
  const double alpha = IncomingAlpha(fan, beta) + order * fan.step;
  const double gamma_squared = 1.0 - alpha * alpha - beta * beta;
  if (gamma_squared <= 0.0) return std::nullopt;
  return Ray{fan.origin + FanShape(fan).ExitOffset(beta) * (fan.turn * fan.a + fan.b),
             alpha * fan.a + beta * fan.b + std::sqrt(gamma_squared) * fan.n};
}

}  // namespace dorsum
