// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "calibration/bundle_problem.h"
#include "calibration/sheet_pictures.h"

namespace dorsum {

struct SheetAssignmentOptions {
  double tolerance = 0.25;  // how far a point may miss a whole order, orders
  double clear = 3.0;       // how much worse the other plane must fit, ratio
  int every_rows = 24;      // one point in so many rows, px; pooled neighbours err alike
  int end_rows = 8;         // points so close to a segment's end may be cut by an edge, px
};

// Gives each segment of each picture its plane and its order by the model's prediction: the plane on which
// its points miss whole orders least. A segment that fits two planes nearly alike is left out, but for the
// plane that the picture was taken for when that plane is known to fill it (`planes` has the expected one
// first). Returns the thinned points.
std::vector<SheetPoint> AssignOrders(const std::vector<SheetPicture>& pictures, const BundleState& state,
                                     const SheetAssignmentOptions& options, const Context& context = {});

}  // namespace dorsum
