// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jobs/reconstruct_options.h"

namespace dorsum::accuracy {

// One way of going from images to a surface: a rung of the ladder from the document's method to ours.
struct Rung {
  std::string name;         // "classic", "+ stripes ridge", ...
  std::string calibration;  // method of calibrating
  ReconstructOptions options;
};

// The document's method in every stage; then one stage after the other as the product does it by default,
// each rung keeping what the rungs before it changed; the last rung is the default. Read from the table of
// options: a stage whose default is still the document's has no rung.
std::vector<Rung> Ladder();

}  // namespace dorsum::accuracy
