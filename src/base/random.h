// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace dorsum {

// A seed for a named thing below a parent seed ("hand", "camera/noise"): the same on every platform, and
// adding one name never changes the draws of another.
std::uint64_t NamedSeed(std::string_view name, std::uint64_t parent = 0);

// SplitMix64's finaliser (Steele, Lea, Flood 2014): a bijection whose output bits all depend on all input
// bits.
std::uint64_t MixBits(std::uint64_t x);

// A small generator with distributions of our own, since the standard's differ between libraries.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : state_(seed) {}
  std::uint64_t Next();                  // uniform over all 64-bit values
  double Uniform();                      // [0, 1)
  double Uniform(double lo, double hi);  // [lo, hi)
  double Normal();                       // mean 0, standard deviation 1

 private:
  std::uint64_t state_;
};

}  // namespace dorsum
