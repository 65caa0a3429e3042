// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "surface/plate.h"

namespace dorsum {

struct PlateStiffnessOptions {
  double mm_per_px = 0.2;  // of the object, above 0
  double window_mm = 3.0;  // curvature is averaged with a Gaussian of this standard deviation, above 0
  double least_curvature = 0.015;     // 1/mm; a plane's curvature is taken as at least that, above 0
  double correlation_area_mm2 = 1.0;  // over which a surface's curvature stays alike, above 0
};

// How much a surface of this kind resists bending, for every node of the lattice `fine`: the curvature is
// taken as random with the variance that the coarser solution shows around the node, so the weight of its
// square is 1 / (variance * correlation area): stiff on a box or the back of a hand, soft where knuckles bend
// or heights jump.
cv::Mat1f LocalStiffness(const PlateLattice& coarse, const PlateLattice& fine,
                         const PlateStiffnessOptions& options);

}  // namespace dorsum
