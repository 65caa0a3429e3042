// SPDX-License-Identifier: Apache-2.0
#include "simulator/mottle.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "base/random.h"

namespace dorsum {
namespace {

constexpr double kSpotMm = 4.0;

// A random number in [-1, 1) for each point of the whole-number lattice.
double AtLattice(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto u = [](std::int64_t i) { return static_cast<std::uint64_t>(i); };
  const std::uint64_t bits =
      MixBits(u(x) * 0x9e3779b97f4a7c15ULL ^ u(y) * 0xc2b2ae3d27d4eb4fULL ^ u(z) * 0x165667b19e3779f9ULL);
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

}  // namespace

double Mottle(const Eigen::Vector3d& world) {
  std::array<std::int64_t, 3> cell{};
  std::array<double, 3> t{};
  for (int i = 0; i < 3; ++i) {
    const double p = world[i] / kSpotMm;
    const double floor = std::floor(p);
    const double f = p - floor;
    cell[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(floor);
    t[static_cast<std::size_t>(i)] = f * f * (3.0 - 2.0 * f);
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
    const double weight = (dx ? t[0] : 1.0 - t[0]) * (dy ? t[1] : 1.0 - t[1]) * (dz ? t[2] : 1.0 - t[2]);
    if (weight > 0.0) sum += weight * AtLattice(cell[0] + dx, cell[1] + dy, cell[2] + dz);
  }
  return sum;
}

}  // namespace dorsum
