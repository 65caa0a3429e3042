// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/context.h"
#include "surface/plate_stack.h"

namespace dorsum {

std::vector<float> Heights(const std::vector<PlateSample>& samples);

void SetWeights(const std::vector<float>& weights, std::vector<PlateSample>* samples);

// Geman and McClure's weights for the residuals against a grid's present surface: the samples' own where a
// residual is far below `scale_mm` and below `sigmas` of their standard deviations, and next to nothing
// beyond.
std::vector<float> Reweigh(const std::vector<PlateSample>& samples, const PlateGrid& grid, double scale_mm,
                           double sigmas, const Context& context);

}  // namespace dorsum
