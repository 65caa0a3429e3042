// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "stripes/joint_pieces.h"

namespace dorsum {

struct JointGraphOptions {
  int neighbours = 6;  // stripes to the right in the same row, of all lasers, that a stripe is compared with
  double max_distance_mm = 16.0;  // and how far these may be
  double max_gap_mm = 22.0;       // how far stripes may be that face each other along the columns
  double independent_rows =
      10.0;  // rows of two stripes that count as one observation, since surfaces are smooth
  double most_observations = 8.0;  // that one pair of pieces may give
  double scale_mm = 0.7,
         scale_slope = 0.4;  // height difference that is nothing special: scale + slope * distance
  double volume_cost = 4.0;  // of one observation outside the working volume
  double volume_tolerance_mm = 0.7;
  double backplane_bonus = 3.0;         // for one observation on the backplane
  double backplane_tolerance_mm = 0.4;  // within which height 0 is met
  double crossing_cost = 15.0;  // of two stripes of one laser side by side whose orders do not grow with u
  double cut_cost = 8.0;        // of a change of order within one stripe
  double kink_cost = 3.0;       // the same where it bends or jumps
};

// Cost of two pieces having certain orders together, at [a * candidates of second + b].
struct JointEdge {
  int first = 0, second = 0;   // pieces
  double observations = 0.0;   // how much there is to compare
  std::vector<float> heights;  // what the two heights cost
  std::vector<float> orders;   // what the two orders cost, if they are of one laser
};

// What speaks for or against the candidates of all pieces, as costs (negative logarithms of likelihoods).
struct JointGraph {
  std::vector<std::vector<float>> unary;  // by piece and candidate
  std::vector<JointEdge> edges;
  std::vector<double> observations;  // of each piece by itself
};

// Costs of heights by themselves (working volume, backplane) and against those of neighbours, whichever laser
// they belong to: at the right orders, the stripes of all lasers interleave to a smooth surface. At wrong
// ones they do not, because one order is worth another height for each laser.
JointGraph BuildJointGraph(const std::vector<JointPiece>& pieces, double min_height_mm, double max_height_mm,
                           const JointGraphOptions& options);

}  // namespace dorsum
