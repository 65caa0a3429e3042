// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jobs/design_device.h"

namespace dorsum {

// How far heights can be told from stripes alone. A stripe's order does not show; where the surface rises,
// the stripe moves along the row, until it lies where its neighbour lay.
struct HeightAmbiguity {
  // The least difference of two heights of the working volume at which a pixel sees neighbouring orders of
  // the same laser, by laser. Where no pixel sees two within the volume: the volume's height over the share
  // of an order that it covers at most, so that the figure goes on growing.
  std::vector<double> single_mm;
  std::vector<bool> beyond_volume;  // by laser: the volume is free of it
  // The least difference of heights at which all lasers agree to `agreement_mm` on a false height, each with
  // neighbours of its own; none: nowhere in the volume.
  std::optional<double> joint_mm;
  // What the lasers' heights differ by at the false height that is most easily believed; none: there is none
  // in the volume. With one laser 0.
  std::optional<double> joint_margin_mm;
};

struct AmbiguityOptions {
  double agreement_mm = 1.0;  // how well a surface is known between the lasers' stripes, 0.01 to 20
  double height_step_mm = 1.0;
  int columns = 9, rows = 5;  // of pixels' rays through the hand area
};

// Follows the rays of a grid of pixels through the working volume. The order of a laser runs along a ray
// without turning back, so false heights are found by interpolation between steps of height.
HeightAmbiguity FindAmbiguity(const DesignedDevice& device, const AmbiguityOptions& options = {});

}  // namespace dorsum
