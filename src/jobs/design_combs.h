// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jobs/design_point.h"

namespace dorsum {

// How the lasers' combs of stripes lie between each other on a level surface of one height, over the part of
// the hand area that the camera sees. In shares of one comb's spacing where no unit is said.
struct CombFigures {
  double height_mm = 0.0;
  double seen = 0.0;             // share of the hand area in the picture
  std::vector<double> coverage;  // by laser: share of the hand area, seen, that is at most half a spacing
                                 // from one of its stripes
  double any_coverage = 0.0;     // the same for at least one laser
  double all_coverage = 0.0;     // the same for every laser
  double spacing_mm = 0.0;       // of one comb, mean
  double largest_gap_mm = 0.0;   // between neighbouring stripes of all lasers together, mean over the area
  double closest = 1.0;          // least distance of two lasers' stripes, mean over the area
  int closest_a = 0, closest_b = 0;  // the two lasers
};

// Stripes of two lasers nearer than this share of a spacing show the same line twice.
inline constexpr double kCombsCoincide = 0.125;

CombFigures FindCombs(const DesignedDevice& device, double height_mm, int columns = 25, int rows = 13);

// The same for `count` heights from the bottom of the working volume to its top.
std::vector<CombFigures> FindCombs(const DesignedDevice& device, int count);

}  // namespace dorsum
