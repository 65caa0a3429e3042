// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "stripes/device_orders.h"
#include "stripes/stripes.h"

namespace dorsum {

struct ObjectSplitOptions {
  double min_height_mm = 0.8;  // lower points are the backplane's, 0.1 to 10 mm
  double noise_factor = 6.0;  // and those lower than this many standard deviations of the backplane's heights
  // A rise out of the backplane that is shorter than `short_rows` is the object's only if it is higher than
  // `short_height_mm`: an edge's light beside a stripe pushes it by about a millimetre.
  int short_rows = 12;
  double short_height_mm = 2.5;
  // What is this much wider than the backplane's stripes, in the median over `width_rows`, is no stripe: an
  // edge of shadow, of which a dark scene under a curved response has many. Skin widens to about 1.5.
  double max_width_ratio = 2.7;  // 1.2 to 10
  int width_rows = 9;
  int short_dip_rows = 6;  // a dip below the least height that is as short as this stays the object's
};

struct ObjectSplit {
  IndexedStripes object;               // segments on the object, each with an order; points compacted
  std::vector<StripePoint> backplane;  // points on the backplane, all lasers; their indices mean nothing
  double threshold_mm = 0.0;           // least height of an object's point that was used
  double backplane_sd_mm = 0.0;        // standard deviation of the backplane's heights
  int wide = 0;                        // points too wide to be a stripe's, in neither
  int below = 0;                       // points deeper below the backplane than that, in neither
};

// Tells the object's stripes from the backplane's by their heights, whole runs of rows at a time. Segments
// without an order are in neither. `elsewhere`: points of the surveyed rows (ridge_survey.h) that are known
// to lie on the backplane, and have no row among `stripes`.
ObjectSplit SplitByHeight(const IndexedStripes& stripes, const std::vector<LaserStripes>& elsewhere,
                          const DeviceOrders& orders, const ObjectSplitOptions& options,
                          const Context& context = {});

}  // namespace dorsum
