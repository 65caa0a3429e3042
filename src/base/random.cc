// SPDX-License-Identifier: Apache-2.0
#include "base/random.h"

#include <cmath>
#include <numbers>

namespace dorsum {

std::uint64_t MixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t NamedSeed(std::string_view name, std::uint64_t parent) {
  std::uint64_t hash = 0xcbf29ce484222325ULL ^ MixBits(parent + 0x9e3779b97f4a7c15ULL);  // FNV-1a
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return MixBits(hash);
}

std::uint64_t Rng::Next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  return MixBits(state_);
}

double Rng::Uniform() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }

double Rng::Uniform(double lo, double hi) { return lo + (hi - lo) * Uniform(); }

double Rng::Normal() {
  // Box and Muller 1958; the second value is dropped so that each call uses exactly two draws.
  const double u = 1.0 - Uniform();
  const double v = Uniform();
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

}  // namespace dorsum
