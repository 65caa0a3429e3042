// SPDX-License-Identifier: Apache-2.0
#include "jobs/stripe_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dorsum {
namespace {

constexpr double kHalfWindow = 3.0;  // standard deviations of the core
constexpr double kFullScale = 0.98;  // 250 of 255, from where a fit takes pixels as clipped
constexpr double kOffCentre = 0.25;  // px: neither on a pixel nor between two

struct Pixel {
  double light = 0.0, slope = 0.0, variance = 0.0;
  double place = 0.0;
};

// Variance of one value of the picture, in light: a code's step is 1/255 of what gamma makes of light.
double WhiteVariance(double light, const SensorDesign& sensor) {
  const double top = std::max(light, 1e-4);
  const double step =
      sensor.gamma * std::pow(top, 1.0 - 1.0 / sensor.gamma) / (255.0 * (1.0 - sensor.black_level));
  double variance = step * step / 12.0;
  if (sensor.full_well_e > 0.0) {
    variance += (light * sensor.full_well_e + sensor.read_noise_e * sensor.read_noise_e) /
                (sensor.full_well_e * sensor.full_well_e);
  }
  return variance;
}

double Grain(double distance_px, const SpeckleDesign& speckle) {
  if (distance_px == 0.0) return 1.0;
  if (speckle.correlation_px <= 0.0) return 0.0;
  const double d = distance_px / (2.0 * speckle.correlation_px);
  return std::exp(-d * d);
}

}  // namespace

double CentreNoise::PooledPx(int rows, const SpeckleDesign& speckle) const {
  if (rows < 5) return row_px;
  // Variance of a quadratic's middle from n even points is 3 (3 n^2 - 7) / (4 n (n^2 - 4)) of one point's.
  const double n = rows;
  const double share = 3.0 * (3.0 * n * n - 7.0) / (4.0 * n * (n * n - 4.0));
  double grains = 1.0;
  for (int d = 1; d < rows; ++d) grains += 2.0 * Grain(d, speckle);
  return std::sqrt(std::min(1.0, share) * white_px * white_px +
                   std::min(1.0, share * grains) * speckle_px * speckle_px);
}

CentreNoise StripeCentreNoise(const StripeProfile& profile, const SensorDesign& sensor,
                              const SpeckleDesign& speckle) {
  const auto gauss = [](double u, double sigma) { return std::exp(-0.5 * u * u / (sigma * sigma)); };
  const double pitch = sensor.bayer ? 2.0 : 1.0;
  const int half = std::max(1, static_cast<int>(std::ceil(kHalfWindow * profile.core_sigma_px / pitch)));
  std::vector<Pixel> pixels;
  CentreNoise noise;
  for (int i = -half; i <= half; ++i) {
    Pixel p;
    p.place = pitch * i + kOffCentre;
    const double core = profile.core_peak * gauss(p.place, profile.core_sigma_px);
    const double wide =
        profile.wide_peak > 0.0 ? profile.wide_peak * gauss(p.place, profile.wide_sigma_px) : 0.0;
    p.light = core + wide;
    p.slope = -p.place * (core / (profile.core_sigma_px * profile.core_sigma_px) +
                          wide / (profile.wide_sigma_px * profile.wide_sigma_px));
    if (p.light + profile.background >= kFullScale) {
      noise.saturated += 1.0;
      continue;
    }
    const double speckled = speckle.contrast * p.light;
    p.variance = WhiteVariance(p.light + profile.background, sensor) + speckled * speckled;
    pixels.push_back(p);
  }
  noise.saturated /= 2.0 * half + 1.0;
  double information = 0.0, white = 0.0, grains = 0.0;
  for (const Pixel& p : pixels) {
    information += p.slope * p.slope / p.variance;
    white += std::pow(p.slope / p.variance, 2) * WhiteVariance(p.light + profile.background, sensor);
    for (const Pixel& q : pixels) {
      grains += p.slope / p.variance * q.slope / q.variance * speckle.contrast * speckle.contrast * p.light *
                q.light * Grain(std::abs(p.place - q.place), speckle);
    }
  }
  if (!(information > 0.0)) {
    noise.white_px = noise.row_px = std::numeric_limits<double>::infinity();
    return noise;
  }
  noise.white_px = std::sqrt(white) / information;
  noise.speckle_px = std::sqrt(std::max(0.0, grains)) / information;
  noise.row_px = std::hypot(noise.white_px, noise.speckle_px);
  return noise;
}

}  // namespace dorsum
