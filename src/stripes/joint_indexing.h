// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "base/context.h"
#include "stripes/device_orders.h"
#include "stripes/joint_graph.h"
#include "stripes/joint_inference.h"
#include "stripes/joint_pieces.h"
#include "stripes/stripes.h"

namespace dorsum {

struct JointIndexingOptions {
  JointPieceOptions pieces;
  JointGraphOptions graph;
  JointInferenceOptions inference;
  // A piece keeps its order only where every other choice costs this much more: of the piece alone, and of
  // the whole surface that it is part of.
  double min_own_margin = 1.0;
  double min_surface_margin = 5.0;
};

// Orders for the stripes of all lasers together, those on the object as well as those on the backplane.
// Every piece of a stripe may have a few orders, each of which puts it at another height. The choice wanted
// keeps inside the working volume, lets the orders of a laser grow along a row, and joins the stripes of all
// lasers, which interleave, to surfaces as smooth as possible; what lies at height 0 all along is the
// backplane. Works with one laser too, though less surely.
//
// Segments are parted where they run from one surface to another. A part whose order stays ambiguous has
// none, and is counted in diagnostics.left_out; diagnostics.corrections stays 0. Lasers that `device` does
// not know are left out. `meanwhile`, if given, is called once, possibly beside the inference, which has one
// thing to do after the other.
IndexedStripes IndexJointly(std::vector<LaserStripes> stripes, const DeviceOrders& device_orders,
                            const JointIndexingOptions& options, const Context& context,
                            const std::function<void()>& meanwhile = {});

}  // namespace dorsum
