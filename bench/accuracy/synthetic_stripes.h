// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "stripes/synthetic_stripes_test.h"

namespace dorsum {

// One of the three cases by which extractors of other scanners were compared: many simultaneous stripes in
// one image of 1600 x 1200 px, sd 2 px, reflectance 10 to 100 %, two humps, matched within 3 px per row.
struct SyntheticStripeCase {
  std::string name;  // "40 clean", "40 dim", "80 saturated"
  SyntheticStripeDesign design;
  SyntheticScore single;  // every row by itself
  SyntheticScore pooled;  // after pooling along the stripe
};

// Renders, finds and scores the three cases; `seed` names the images.
std::vector<SyntheticStripeCase> MeasureSyntheticStripes(std::uint64_t seed, const Context& context);

}  // namespace dorsum
