// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/context.h"
#include "geometry/calibration.h"
#include "stripes/device_orders.h"
#include "stripes/stripes.h"
#include "surface/surface_point.h"

namespace dorsum {

struct TriangulationOptions {
  SheetModel sheets = SheetModel::kPlane;
  bool correction = true;  // apply equation 3.9 to plane sheets
};

struct Triangulation {
  SurfacePoints points;   // by laser, then as in the stripes
  int without_order = 0;  // stripe points whose order is not known
  int without_sheet = 0;  // stripe points of an order that the calibration has no sheet for
};

// Surface reconstruction of Algorithm 3 (§3.6): each indexed stripe point's camera ray meets the sheet of its
// order. With `correction`, z is replaced by equation 3.9 and the point slides along its camera ray to that
// height: the document changes z alone, which would leave the ray that the point was seen on.
// sigma holds the stripe's own noise, carried through the intersection, and the calibration's residual.
Triangulation Triangulate(const IndexedStripes& stripes, const DeviceOrders& orders,
                          const TriangulationOptions& options, const Context& context = {});

}  // namespace dorsum
