// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "accuracy/results.h"

namespace dorsum::accuracy {

// Errors of a box's models with the document's Table 5.1 beside them, for the captures box13.5* and box25.5*
// that come first; by rung.
std::string Table51(const Results& results, const std::string& design, const std::string& rung);

// Differences between repeats of box25.5 (5.2), with the document's Table 5.2 beside them.
std::string Table52(const Results& results, const std::string& design, const std::string& rung);

}  // namespace dorsum::accuracy
