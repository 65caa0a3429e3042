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
  double reach_mm = 12.0;         // how far from the outline the term reaches, 2 to 50
  double neighbourhood_mm = 7.0;  // samples that decide for one place of the outline, 2 to 30
};

// Where a rounded body turns away from the camera, its height falls like the root of the distance d to its
// outline (Koenderink 1984): infinitely steep, which no plate can follow between stripes. The rim term
//   amplitude * sqrt(d) * (1 - d / reach)^2
// takes that part away, and what is left is smooth. The amplitude, mm^(1/2), varies slowly along the outline
// and is near zero at sharp edges such as a box's; it is fitted to the samples around each place.
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
