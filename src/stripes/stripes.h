// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dorsum {

inline constexpr std::int32_t kNoPoint = -1;

// One place where a stripe crosses an image row (the document's StripePoint, §4.3). Neighbours are indices
// into the same laser's list of points: left and right on the adjacent stripes in the same row, top and
// bottom on the same stripe.
struct StripePoint {
  float u = 0.0F, v = 0.0F;  // px, in the captured, distorted image
  float sd_px = 0.0F;        // one standard deviation of u
  // u before rows were pooled, and the standard deviation that rows which err independently would need to say
  // no more than these do together, px; 0: rows were not pooled.
  float row_u = 0.0F, row_sd_px = 0.0F;
  float peak = 0.0F;   // green value at the stripe (classic) or its rise around it (ridges), 0 to 255
  float width = 0.0F;  // one standard deviation of the stripe's profile, px; 0: not measured
  std::int32_t segment = kNoPoint;
  std::int32_t left = kNoPoint, right = kNoPoint, top = kNoPoint, bottom = kNoPoint;
};

// A connected piece of one stripe (StripeSegment, §4.3): points [first, first + count) of the list, by
// growing row, at most one in each row.
struct StripeSegment {
  std::int32_t first = 0, count = 0;
  float min_u = 0.0F, max_u = 0.0F, min_v = 0.0F, max_v = 0.0F;  // extremes, px
  float mean_peak = 0.0F;                                        // mean green value along the stripe
  std::optional<int> order;  // diffraction order; none as long as it is not known
};

// All stripes of one laser in one image, indexed or not.
struct LaserStripes {
  int laser = 0;
  std::vector<StripePoint> points;
  std::vector<StripeSegment> segments;
};

// One node of the hierarchy of §3.5 (StripeNode, §4.3): node i belongs to segment i. Parents lie to the
// left and share rows with it, children to the right.
struct StripeNode {
  std::vector<std::int32_t> parents, children;
  int level = 0;
};

// What indexing says about itself.
struct IndexingDiagnostics {
  int laser = 0;
  int segments = 0;     // found
  int left_out = 0;     // without an order
  int corrections = 0;  // changed by Algorithm 2
};

struct IndexedStripes {
  std::vector<LaserStripes> lasers;
  std::vector<IndexingDiagnostics> diagnostics;  // one per laser
};

}  // namespace dorsum
