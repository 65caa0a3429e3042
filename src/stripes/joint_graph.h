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
  double scale_mm = 0.4,
         scale_slope = 0.25;  // height difference that is nothing special: scale + slope * distance
  double most_cost = 4.0;     // towards which the cost of a height difference grows, for one observation
  double volume_cost = 6.0;   // of one observation outside the working volume
  double volume_tolerance_mm = 0.4;     // and what noise and calibration may do; twice that costs it all
  double backplane_start = 8.0;         // for being on the backplane at all
  double backplane_bonus = 6.0;         // and for each observation there
  double backplane_tolerance_mm = 0.4;  // within which height 0 is met; at twice that nothing is left of it
  double crossing_cost = 15.0;  // of two stripes of one laser side by side whose orders do not grow with u
  // Rows over which that may happen, since rows are not quite the planes of camera and light, and over which
  // the cost grows from nothing to all.
  double crossing_free_rows = 6.0, crossing_rows = 12.0;
  double cut_cost = 40.0;  // of a change of order within one stripe
  double kink_cost = 3.0;  // the same where it bends or jumps
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
// ones they do not, because one order is worth another height for each laser. `sample_rows` is
// JointPieceOptions'.
JointGraph BuildJointGraph(const std::vector<JointPiece>& pieces, int sample_rows, double min_height_mm,
                           double max_height_mm, const JointGraphOptions& options,
                           const Context& context = {});

}  // namespace dorsum
