// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "base/context.h"
#include "simulator/renderer.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Where an image row meets the middle of a visible and lit stripe.
struct TrueStripePoint {
  int order = 0;
  int row = 0;
  double u = 0.0;  // px, sub-pixel, in the distorted image
  double z = 0.0;  // mm
  Material material = Material::kBackplane;
  double irradiance = 0.0;  // at the stripe's middle; 1 brings a white surface to full scale
};

// All of one laser, row by row from left to right. Exact: the order as a real number is followed along each
// row with rays of its own, and solved for whole numbers to about 1e-7 px.
Result<std::vector<TrueStripePoint>> TrueStripes(const VirtualDevice& device, const Stage& stage, int laser,
                                                 const Context& context);

// The truth folder of a capture: height.png, material.png and reference.ply; and stripesK.csv.gz of each
// laser.
Status WriteSurfaceTruth(const Stage& stage, const std::filesystem::path& dir);
Status WriteStripeTruth(const VirtualDevice& device, const Stage& stage, int laser,
                        const std::filesystem::path& dir, const Context& context);

}  // namespace dorsum
