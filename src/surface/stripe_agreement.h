// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "surface/outline.h"
#include "surface/surface_point.h"

namespace dorsum {

struct StripeAgreementOptions {
  double mm_per_px = 0.2;     // of the object, above 0
  double slack_mm = 1.5;      // neighbours in a row agree up to this height difference
  double max_slope = 4.0;     // plus this much per mm between them, a box's wall seen at 14 degrees, above 0
  double max_step_mm = 20.0;  // but never beyond it: the next order is 33 to 51 mm away, above 0
  double max_distance_mm = 20.0;  // neighbours further apart say nothing about each other, above 0
};

// Finds stripes that cannot belong to the surface their neighbours lie on: a wrong order puts them tens of mm
// above or below. Stripes are cut into runs without jumps; runs that are neighbours in the image rows, with
// the object between them, agree or contradict; runs that agree form groups. A group that is contradicted by
// larger ones in at least as many rows as its own runs agree in is out of place: so one, two or three wrong
// stripes between right ones are found, and the two levels of a stepped body are not. Returns for each point
// whether it is out of place.
std::vector<bool> FindMisplaced(const SurfacePoints& points, const Outline& outline,
                                const StripeAgreementOptions& options, const Context& context = {});

}  // namespace dorsum
