// SPDX-License-Identifier: Apache-2.0
#include "accuracy/guard.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "accuracy/summary.h"

namespace dorsum::accuracy {
namespace {

// Smaller is better of the first, greater of the second.
const std::vector<std::string> kErrors = {"z_rmse",         "wrong",       "stray",          "beyond",
                                          "xy_rmse",        "sigma_ratio", "surface_z_rmse", "surface_wrong",
                                          "surface_beyond", "radius_error"};
const std::vector<std::string> kShares = {"complete", "surface_cover"};

// Results by group: "default / box25.5".
std::map<std::string, const CaptureResult*> Groups(const Results& results) {
  std::map<std::string, const CaptureResult*> groups;
  for (const std::string& design : DesignsOf(results)) {
    const std::vector<std::string> rungs = RungsOf(results, design);
    for (const DeviceResult& d : results.devices) {
      if (d.design != design) continue;
      for (const CaptureResult& c : d.captures) {
        if (d.rung == rungs.front()) groups["classic / " + c.name] = &c;
        if (d.rung == rungs.back()) groups["default / " + c.name] = &c;
      }
    }
  }
  return groups;
}

std::string Text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::vector<std::string> Regressions(const Results& results, const LimitTable& recorded) {
  std::vector<std::string> found;
  const auto groups = Groups(results);
  for (const auto& [group, limits] : recorded) {
    const auto capture = groups.find(group);
    if (capture == groups.end() || !capture->second->refused.empty()) {
      found.push_back(group + ": no surface" +
                      (capture == groups.end() ? std::string() : ": " + capture->second->refused));
      continue;
    }
    for (const auto& [figure, limit] : limits) {
      const auto value = capture->second->figures.find(figure);
      if (value == capture->second->figures.end()) {
        found.push_back(group + ": " + figure + " is missing");
      } else if (!limit.Holds(value->second)) {
        found.push_back(group + ": " + figure + " is " + Text(value->second) + ", recorded " + limit.Text());
      }
    }
  }
  return found;
}

LimitTable RecordLimits(const Results& results) {
  constexpr double kMargin = 0.1, kLeast = 0.001;
  LimitTable limits;
  for (const auto& [group, capture] : Groups(results)) {
    for (const std::string& figure : kErrors) {
      const auto value = capture->figures.find(figure);
      if (value == capture->figures.end()) continue;
      limits[group][figure].max = value->second + std::max(kMargin * value->second, kLeast);
    }
    for (const std::string& figure : kShares) {
      const auto value = capture->figures.find(figure);
      if (value == capture->figures.end()) continue;
      limits[group][figure].min = value->second - std::max(kMargin * (1.0 - value->second), kLeast);
    }
  }
  return limits;
}

}  // namespace dorsum::accuracy
