// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/context.h"
#include "stripes/device_orders.h"
#include "stripes/stripes.h"

namespace dorsum {

struct JointPieceOptions {
  int sample_rows = 3;  // heights are worked out in every n-th image row, 1 to 10
  int block_rows = 48;  // stripes are cut at every n-th row too, so that one mistake stays short, 12 to 2000
  float max_jump_px = 2.5F;   // a stripe that jumps further between two points is cut, px
  int max_gap_rows = 3;       // and one that is interrupted for longer, rows
  int kink_rows = 7;          // rows on each side of a point whose lines are compared, 4 to 30
  float step_px = 0.8F;       // how far the two lines may miss each other where they meet, px
  float kink_px = 1.5F;       // and how far half that many rows on, px
  double slack_mm = 3.0;      // heights this far outside the working volume are still written down, mm
  float backplane_mm = 0.4F;  // a stripe that lies this close to height 0 and then leaves it is cut, mm
  int backplane_samples = 3;  // samples that it must lie there, and must be away, 2 to 20
};

// One place of a piece.
struct JointSample {
  float u = 0.0F, v = 0.0F;  // px
};

// A part of one segment that is taken to lie on one surface, so that it has one order.
struct JointPiece {
  int laser = 0;                      // index into the list of stripes, not the laser's number
  std::int32_t segment = 0;           // before cutting
  std::int32_t first = 0, count = 0;  // points
  bool follows = false;      // the piece before it is the same segment's, cut between without a reason
  int lowest = 0, step = 1;  // candidate k is order lowest + k * step, by growing height
  int candidates = 0;
  float px_per_mm = 0.0F;  // at the middle of the working volume
  std::vector<JointSample> samples;
  // The heights at the samples, mm, one for each candidate of the first sample, then of the second, and so
  // on; NaN where the pixel's ray does not meet that candidate's sheet within the working volume and its
  // slack.
  std::vector<float> heights;

  const float* Heights(std::size_t sample) const {
    return heights.data() + sample * static_cast<std::size_t>(candidates);
  }
  int Order(int candidate) const { return lowest + candidate * step; }
  // None where that order is no candidate.
  std::optional<int> Candidate(int order) const;
};

// Cuts all segments of all lasers into pieces and works out every height that each of them may have. A laser
// that the device does not know, or whose model it does not hold, gets no pieces. Pieces come by laser,
// segment and row.
std::vector<JointPiece> CutPieces(const std::vector<LaserStripes>& stripes, const DeviceOrders& orders,
                                  const JointPieceOptions& options, const Context& context);

}  // namespace dorsum
