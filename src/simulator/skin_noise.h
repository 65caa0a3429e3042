// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace dorsum {

// Smooth noise of mean 0 and standard deviation about 1 with bumps of about `pitch_mm` and, at half the
// height, half that size: gradients at the points of a lattice, blended with two continuous derivatives
// (Perlin 2002).
class SkinNoise {
 public:
  SkinNoise(std::uint64_t seed, double pitch_mm) : seed_(seed), pitch_(pitch_mm) {}
  double At(const Eigen::Vector3d& point) const;

 private:
  std::uint64_t seed_;
  double pitch_;
};

}  // namespace dorsum
