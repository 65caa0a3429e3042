// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "accuracy/limits.h"
#include "accuracy/results.h"

namespace dorsum::accuracy {

// What is asked of a design beside what the last rung reached: mean and worst over its captures, and how many
// captures miss it. `group` names the design in `asked`; nothing when it is not there.
std::string AcceptanceTable(const Results& results, const std::string& design, const std::string& group,
                            const LimitTable& asked);

// One row for each rung, from the document's method to ours: means over the captures of a kind.
std::string LadderTable(const Results& results, const std::string& design);

// Where the errors come from (accuracy/budget.h), by kind of scene, on the rungs that have a budget.
std::string BudgetTable(const Results& results, const std::string& design);

// One row for each capture of one rung, and what was refused below it.
std::string CaptureTable(const Results& results, const std::string& design, const std::string& rung);

}  // namespace dorsum::accuracy
