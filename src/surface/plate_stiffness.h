// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "surface/plate.h"

namespace dorsum {

struct PlateStiffnessOptions {
  double mm_per_px = 0.2;  // of the object, above 0
  double window_mm = 3.5;  // curvature is averaged with a Gaussian of this standard deviation, above 0
  double least_curvature = 0.015;     // 1/mm; a plane's curvature is taken as at least that, above 0
  double correlation_area_mm2 = 6.0;  // over which a surface's curvature stays alike, above 0
  // How much of the curvature in one direction is believed of the others too, 0 (none) to 1 (all alike).
  double share_between = 0.15;
};

// How much a surface of this kind resists bending, for every node of the lattice `fine`: the second
// derivatives are taken as random with the variances that the coarser solution shows around the node, so the
// weights of their squares are 1 / (variance * correlation area): stiff on a box or the back of a hand, soft
// where knuckles bend or heights jump; on a finger soft around it and stiff along it.
cv::Mat3f LocalStiffness(const PlateLattice& coarse, const PlateLattice& fine,
                         const PlateStiffnessOptions& options);

}  // namespace dorsum
