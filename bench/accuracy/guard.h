// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "accuracy/limits.h"
#include "accuracy/results.h"

namespace dorsum::accuracy {

// Guards against getting worse: every capture's figures on the first and the last rung, which go by the names
// "classic" and "default", held against recorded limits.

// One sentence for each figure that breaks its limit, each capture that is refused, and each group of limits
// for which there is no capture.
std::vector<std::string> Regressions(const Results& results, const LimitTable& recorded);

// Limits that these results keep with a margin of a tenth, or of one in a thousand where the figure is next
// to none.
LimitTable RecordLimits(const Results& results);

}  // namespace dorsum::accuracy
