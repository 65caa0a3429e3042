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

double IncomingAlpha(const DiffractedFan& fan, double beta) {
  return std::sin(fan.tilt) + fan.turn * beta + EffectiveBow(fan) * (std::sqrt(1.0 - beta * beta) - 1.0);
}

namespace {

// Where on the grating's b axis the ray with direction cosine beta arrives.
double ExitOffset(const DiffractedFan& fan, double beta) {
  const double alpha = IncomingAlpha(fan, beta);
  return fan.fan_distance_mm * beta / std::sqrt(1.0 - alpha * alpha - beta * beta);
}

}  // namespace

std::optional<FanCoordinates> Locate(const DiffractedFan& fan, const Eigen::Vector3d& world) {
  const Eigen::Vector3d d = world - fan.origin;
  const double x = fan.a.dot(d), y = fan.b.dot(d), z = fan.n.dot(d);
  if (z <= 0.0) return std::nullopt;
  // beta solves beta = (y - y_g(beta)) / |(x, y - y_g, z)|; the fan starts close behind the grating compared
  // with the point's distance, so the iteration shrinks the error by that ratio each time. It begins with the
  // answer for a fan without tilt, whose light spreads over y from a point fan_distance behind (0, 0, 0).
  FanCoordinates c;
  double y_g = y * fan.fan_distance_mm / (std::sqrt(x * x + z * z) + fan.fan_distance_mm);
  for (int i = 0; i < 60; ++i) {
    const double dx = x - fan.turn * y_g, dy = y - y_g;
    c.distance_mm = std::sqrt(dx * dx + dy * dy + z * z);
    const double beta = dy / c.distance_mm;
    const double change = std::abs(beta - c.beta);
    c.beta = beta;
    y_g = ExitOffset(fan, beta);
    if (i > 0 && change < 1e-15) break;
  }
  c.alpha = (x - fan.turn * y_g) / c.distance_mm;
  c.alpha_in = IncomingAlpha(fan, c.beta);
  c.exit = fan.origin + y_g * (fan.turn * fan.a + fan.b);
  return c;
}

std::optional<Ray> DiffractedRay(const DiffractedFan& fan, int order, double beta) {
  const double alpha = IncomingAlpha(fan, beta) + order * fan.step;
  const double gamma_squared = 1.0 - alpha * alpha - beta * beta;
  if (gamma_squared <= 0.0) return std::nullopt;
  return Ray{fan.origin + ExitOffset(fan, beta) * (fan.turn * fan.a + fan.b),
             alpha * fan.a + beta * fan.b + std::sqrt(gamma_squared) * fan.n};
}

}  // namespace dorsum
