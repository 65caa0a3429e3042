// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

#include "studio/stage_collector.h"

namespace dorsum {

// What a stage's key means to a person.
QString StageTitle(const std::string& key);

// Points, faces and seconds of a chain, each with how much it changed since `before` (may be none); or why it
// ended early and what can be done.
QString StageFigures(const ChainStages& now, const ChainStages* before);

}  // namespace dorsum
