// SPDX-License-Identifier: Apache-2.0
#include "accuracy/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "accuracy/markdown.h"
#include "accuracy/statistics.h"
#include "accuracy/summary.h"

namespace dorsum::accuracy {
namespace {

constexpr std::array kKinds = {SceneKind::kBox, SceneKind::kHand, SceneKind::kSphere, SceneKind::kCylinder};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const std::vector<double>& Values(const std::map<std::string, std::vector<double>>& figures,
                                  const std::string& name) {
  static const std::vector<double> kNone;
  const auto found = figures.find(name);
  return found == figures.end() ? kNone : found->second;
}

double MeanOrNan(const std::vector<double>& values) { return values.empty() ? kNan : Mean(values); }

// The value that comes closest to breaking a limit, or breaks it most.
double Worst(const std::vector<double>& values, const Limit& limit) {
  const auto margin = [&](double v) {
    const double below = limit.max ? *limit.max - v : std::numeric_limits<double>::max();
    const double above = limit.min ? v - *limit.min : std::numeric_limits<double>::max();
    return std::min(below, above);
  };
  return *std::min_element(values.begin(), values.end(),
                           [&](double a, double b) { return margin(a) < margin(b); });
}

std::string Share(std::ptrdiff_t some, std::size_t all) {
  return "**" + std::to_string(some) + " of " + std::to_string(all) + "**";
}

}  // namespace

std::string AcceptanceTable(const Results& results, const std::string& design, const std::string& group,
                            const LimitTable& asked) {
  const std::vector<std::string> rungs = RungsOf(results, design);
  if (rungs.empty()) return "";
  MarkdownTable table({"scene", "figure", "asked", "mean", "worst", "missed by"});
  bool any = false;
  const auto judge = [&](const std::string& scene, const Collected& reached) {
    const auto limits = asked.find(group + " / " + scene);
    if (limits == asked.end()) return;
    any = true;
    for (const auto& [figure, limit] : limits->second) {
      const std::vector<double>& values = Values(reached.figures, figure);
      if (values.empty()) continue;
      const auto missed =
          std::count_if(values.begin(), values.end(), [&](double v) { return !limit.Holds(v); });
      table.Row({scene, "`" + figure + "`", limit.Text(), Fixed(Mean(values)), Fixed(Worst(values, limit)),
                 missed == 0 ? "–" : Share(missed, values.size())});
    }
    if (reached.refused > 0) {
      table.Row({scene, "refused", "0", "–", "–",
                 Share(reached.refused, static_cast<std::size_t>(reached.captures))});
    }
  };
  for (const SceneKind kind : kKinds) judge(KindName(kind), Collect(results, design, rungs.back(), kind));
  judge("calibration", CollectDevices(results, design, rungs.back()));
  return any ? table.text() : "";
}

std::string LadderTable(const Results& results, const std::string& design) {
  constexpr std::array kFigures = {"z_rmse",
                                   "wrong",
                                   "complete",
                                   "stray",
                                   "beyond",
                                   "sigma_ratio",
                                   "mask_missing",
                                   "mask_beyond",
                                   "surface_z_rmse",
                                   "surface_z_median_abs",
                                   "surface_z_p95_abs",
                                   "surface_cover",
                                   "surface_beyond"};
  std::vector<std::string> head = {"scene", "stages"};
  for (const char* figure : kFigures) head.push_back("`" + std::string(figure) + "`");
  head.emplace_back("refused");
  MarkdownTable table(head);
  for (const SceneKind kind : kKinds) {
    for (const std::string& rung : RungsOf(results, design)) {
      const Collected reached = Collect(results, design, rung, kind);
      if (reached.captures == 0) continue;
      std::vector<std::string> row = {KindName(kind), rung};
      for (const char* figure : kFigures) row.push_back(Fixed(MeanOrNan(Values(reached.figures, figure))));
      row.push_back(reached.refused == 0
                        ? "–"
                        : std::to_string(reached.refused) + " of " + std::to_string(reached.captures));
      table.Row(row);
    }
  }
  return table.text();
}

std::string BudgetTable(const Results& results, const std::string& design) {
  constexpr std::array kParts = {"total",         "plane",         "ridge",         "index",        "stray",
                                 "without_plane", "without_ridge", "without_index", "without_stray"};
  MarkdownTable table({"scene", "stages", "whole", "plane", "ridge", "index", "stray", "without plane",
                       "without ridge", "without index", "without stray", "surface", "fusion alone",
                       "surface, 95 %", "fusion alone, 95 %"});
  for (const SceneKind kind : kKinds) {
    for (const std::string& rung : RungsOf(results, design)) {
      const Collected reached = Collect(results, design, rung, kind);
      if (reached.budget.empty()) continue;
      std::vector<std::string> row = {KindName(kind), rung};
      for (const char* part : kParts) row.push_back(Fixed(Rms(Values(reached.budget, part))));
      row.push_back(Fixed(Rms(Values(reached.figures, "surface_z_rmse"))));
      row.push_back(Fixed(Rms(Values(reached.budget, "fusion"))));
      row.push_back(Fixed(MeanOrNan(Values(reached.figures, "surface_z_p95_abs"))));
      row.push_back(Fixed(MeanOrNan(Values(reached.budget, "fusion_p95_abs"))));
      table.Row(row);
    }
  }
  return table.text();
}

std::string CaptureTable(const Results& results, const std::string& design, const std::string& rung) {
  constexpr std::array kFigures = {"z_rmse",
                                   "z_median_abs",
                                   "wrong",
                                   "complete",
                                   "stray",
                                   "beyond",
                                   "xy_rmse",
                                   "sigma_ratio",
                                   "surface_z_rmse",
                                   "surface_z_median_abs",
                                   "surface_z_p95_abs",
                                   "surface_wrong",
                                   "surface_cover",
                                   "surface_beyond"};
  std::vector<std::string> head = {"seed", "capture", "points"};
  for (const char* figure : kFigures) head.push_back("`" + std::string(figure) + "`");
  MarkdownTable table(head);
  std::string refused;
  for (const DeviceResult& d : results.devices) {
    if (d.design != design || d.rung != rung) continue;
    if (!d.refused.empty()) refused += "\nRefused to calibrate `" + d.seed + "`: " + d.refused + "\n";
    for (const CaptureResult& c : d.captures) {
      const std::string who = "`" + c.name + "`" + (d.seed.empty() ? "" : " of `" + d.seed + "`");
      if (!c.refused.empty()) {
        refused += "\nRefused: " + who + ": " + c.refused + "\n";
        continue;
      }
      for (const std::string& warning : c.warnings) refused += "\nWarned: " + who + ": " + warning + "\n";
      std::vector<std::string> row = {d.seed.empty() ? "–" : d.seed, c.name,
                                      Fixed(c.figures.at("points"), 0)};
      for (const char* figure : kFigures) {
        const auto found = c.figures.find(figure);
        row.push_back(Fixed(found == c.figures.end() ? kNan : found->second));
      }
      table.Row(row);
    }
  }
  return table.text() + refused;
}

}  // namespace dorsum::accuracy
