// SPDX-License-Identifier: Apache-2.0
#include "accuracy/summary.h"

#include <algorithm>

namespace dorsum::accuracy {
namespace {

void AddOnce(const std::string& name, std::vector<std::string>* names) {
  if (std::find(names->begin(), names->end(), name) == names->end()) names->push_back(name);
}

}  // namespace

Collected Collect(const Results& results, const std::string& design, const std::string& rung,
                  SceneKind kind) {
  Collected out;
  for (const DeviceResult& d : results.devices) {
    if (d.design != design || d.rung != rung) continue;
    for (const CaptureResult& c : d.captures) {
      if (DescribeScene(c.name).kind != kind) continue;
      ++out.captures;
      out.refused += c.refused.empty() ? 0 : 1;
      double worst_laser = 0.0;
      for (const auto& [name, value] : c.figures) {
        out.figures[name].push_back(value);
        if (name.starts_with("z_rmse_laser")) worst_laser = std::max(worst_laser, value);
      }
      if (worst_laser > 0.0) out.figures["z_rmse_laser"].push_back(worst_laser);
      for (const auto& [name, value] : c.budget) out.budget[name].push_back(value);
    }
    if (kind != SceneKind::kBox) continue;
    for (const RepeatDifference& r : d.repeats) {
      if (r.model == "merged") out.figures["repeat_difference"].push_back(r.diff_mm);
    }
  }
  return out;
}

Collected CollectDevices(const Results& results, const std::string& design, const std::string& rung) {
  Collected out;
  for (const DeviceResult& d : results.devices) {
    if (d.design != design || d.rung != rung) continue;
    ++out.captures;
    out.refused += d.refused.empty() ? 0 : 1;
    for (const auto& [name, value] : d.figures) out.figures[name].push_back(value);
  }
  return out;
}

std::vector<std::string> DesignsOf(const Results& results) {
  std::vector<std::string> names;
  for (const DeviceResult& d : results.devices) AddOnce(d.design, &names);
  return names;
}

std::vector<std::string> RungsOf(const Results& results, const std::string& design) {
  std::vector<std::string> names;
  for (const DeviceResult& d : results.devices) {
    if (d.design == design) AddOnce(d.rung, &names);
  }
  return names;
}

}  // namespace dorsum::accuracy
