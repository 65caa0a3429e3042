// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "surface/outline.h"
#include "surface/plate.h"

namespace dorsum {

struct RimOptions {
  double mm_per_px = 0.2;         // of the object, above 0
  double radius_mm = 4.0;         // how far from the outline a surface may turn away from the camera, 1 to 20
  double neighbourhood_mm = 7.0;  // samples that decide for one place of the outline, 2 to 30
  double prior_sd = 0.7;          // of the amplitude, where samples say little
};

// Where a rounded body turns away from the camera, its height falls like the root of the distance d to its
// outline (Koenderink 1984): infinitely steep, which no plate can follow between stripes. The rim term
// amplitude * g(d), g a quarter of a circle of `radius_mm`, takes that part away, and what is left is smooth.
// The amplitude varies slowly along the outline and is zero at sharp edges such as a box's.
class Rim {
 public:
  Rim(const std::vector<PlateSample>& samples, const Outline& outline, const RimOptions& options,
      const Context& context = {});

  // The rim term at an image point, mm.
  float Height(double u, double v) const;

 private:
  float Profile(double distance_px) const;

  const Outline& outline_;
  RimOptions options_;
  PlateLattice amplitude_;
};

}  // namespace dorsum
