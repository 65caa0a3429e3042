// SPDX-License-Identifier: Apache-2.0
#include "simulator/skin_noise.h"

#include <cmath>

#include "base/random.h"

namespace dorsum {
namespace {

// The share of a lattice point at an offset from it: a slope that its hash draws, 10 bits for each axis.
double Slope(std::uint64_t seed, std::int64_t i, std::int64_t j, std::int64_t k, double x, double y,
             double z) {
  const std::uint64_t cell = static_cast<std::uint64_t>(i) * 0x8da6b343u +
                             static_cast<std::uint64_t>(j) * 0xd8163841u +
                             static_cast<std::uint64_t>(k) * 0xcb1ab31fu;
  const std::uint64_t bits = MixBits(seed ^ cell);
  auto axis = [bits](int shift) { return static_cast<double>((bits >> shift) & 1023) / 511.5 - 1.0; };
  return axis(0) * x + axis(10) * y + axis(20) * z;
}

double Fade(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

double Lerp(double a, double b, double t) { return a + (b - a) * t; }

double Octave(std::uint64_t seed, const Eigen::Vector3d& p) {
  const double fi = std::floor(p.x()), fj = std::floor(p.y()), fk = std::floor(p.z());
  const auto i = static_cast<std::int64_t>(fi), j = static_cast<std::int64_t>(fj),
             k = static_cast<std::int64_t>(fk);
  const double x = p.x() - fi, y = p.y() - fj, z = p.z() - fk;
  const double u = Fade(x), v = Fade(y), w = Fade(z);
  auto row = [&](int dj, int dk) {
    return Lerp(Slope(seed, i, j + dj, k + dk, x, y - dj, z - dk),
                Slope(seed, i + 1, j + dj, k + dk, x - 1, y - dj, z - dk), u);
  };
  return Lerp(Lerp(row(0, 0), row(1, 0), v), Lerp(row(0, 1), row(1, 1), v), w);
}

}  // namespace

double SkinNoise::At(const Eigen::Vector3d& point) const {
  // A turn between the octaves and off the axes keeps the lattice from showing.
  const Eigen::Vector3d a(0.80 * point.x() + 0.60 * point.y(),
                          -0.48 * point.x() + 0.64 * point.y() + 0.60 * point.z(),
                          0.36 * point.x() - 0.48 * point.y() + 0.80 * point.z());
  const Eigen::Vector3d b(a.y(), 0.8 * a.z() - 0.6 * a.x(), 0.6 * a.z() + 0.8 * a.x());
  constexpr double kPerSd = 4.7;
  return kPerSd * (Octave(seed_, a / pitch_) + 0.5 * Octave(seed_ + 1, b / (0.5 * pitch_)));
}

}  // namespace dorsum
