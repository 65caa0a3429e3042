// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/result.h"

namespace dorsum::speed {

// What one run measured, by name: times in ms ("default/threads:2"), and other numbers ("peak_mb").
using Measured = std::map<std::string, double>;

// A ratio that is asked for, and what came out. Times alone would say more of the machine than of the
// program.
struct SpeedFigure {
  std::string what;
  std::string asked;     // "≤ 8"
  double reached = 0.0;  // NaN: not measured
  bool met = false;
};

std::vector<SpeedFigure> FiguresOf(const Measured& measured);

// The figures as a table in Markdown; detectors of stripes beside each other; stages of a reconstruction and
// their shares; sizes and lasers.
std::string FigureTable(const Measured& measured);
std::string DetectorTable(const Measured& measured);
std::string StageTable(const Measured& measured);
std::string SizeTable(const Measured& measured);

Json MeasuredToJson(const Measured& measured);
Result<Measured> MeasuredFromJson(const Json& json, const std::string& where);

}  // namespace dorsum::speed
