// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "calibration/bundle_problem.h"

namespace dorsum {

// Turns the world about its z until x is perpendicular to the central stripe that the laser
// state->fans[reference] throws on the backplane at the origin (DESIGN §2). What is seen in the images stays.
void TurnWorldToCentral(std::size_t reference, BundleState* state);

}  // namespace dorsum
