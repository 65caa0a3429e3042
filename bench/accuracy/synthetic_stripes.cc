// SPDX-License-Identifier: Apache-2.0
#include "accuracy/synthetic_stripes.h"

#include <utility>
#include <vector>

#include "accuracy/markdown.h"
#include "stripes/pooling.h"
#include "stripes/ridge.h"
#include "stripes/synthetic_stripes_test.h"

namespace dorsum::accuracy {
namespace {

std::vector<std::pair<std::string, SyntheticStripeDesign>> Cases(std::uint64_t seed) {
  SyntheticStripeDesign clean, dim, saturated;
  dim.peak = 60.0;
  dim.noise_sd = 2.0;
  saturated.stripes = 80;
  saturated.peak = 400.0;
  std::vector<std::pair<std::string, SyntheticStripeDesign>> cases = {
      {"40 clean", clean}, {"40 dim", dim}, {"80 saturated", saturated}};
  for (auto& [name, design] : cases) design.seed = seed;
  return cases;
}

}  // namespace

DeviceResult MeasureSyntheticStripes(std::uint64_t seed, const Context& context) {
  DeviceResult result;
  result.design = "synthetic stripes";
  result.seed = std::to_string(seed);
  result.rung = "default";
  for (const auto& [name, design] : Cases(seed)) {
    const SyntheticStripes scene = RenderSyntheticStripes(design);
    const LaserStripes rows = FindRidges(scene.image, cv::Mat(), 0, {}, context);
    const SyntheticScore single = ScoreSyntheticStripes(scene, rows);
    const SyntheticScore pooled = ScoreSyntheticStripes(scene, PoolAlongStripes(rows, {}, context));
    CaptureResult one;
    one.name = name;
    one.figures = {{"recall", single.recall},           {"false", single.false_share},
                   {"rmse_px", single.rmse_px},         {"bound_ratio", single.Efficiency()},
                   {"sigma_ratio", single.sigma_ratio}, {"pooled_rmse_px", pooled.rmse_px}};
    result.captures.push_back(std::move(one));
  }
  return result;
}

std::string SyntheticTable(const DeviceResult& result) {
  MarkdownTable table({"stripes", "recall", "asked", "false", "rmse, px", "asked", "over the bound", "asked",
                       "sigma_ratio", "pooled rmse, px"});
  for (const CaptureResult& one : result.captures) {
    const auto figure = [&](const std::string& name, int decimals) {
      const auto found = one.figures.find(name);
      return found == one.figures.end() ? "–" : Fixed(found->second, decimals);
    };
    const bool dim = one.name == "40 dim";
    table.Row({one.name, figure("recall", 4), "> 0.95", figure("false", 4), figure("rmse_px", 3),
               dim ? "–" : "< 0.1", figure("bound_ratio", 2), dim ? "≤ 1.3" : "–", figure("sigma_ratio", 2),
               figure("pooled_rmse_px", 3)});
  }
  return table.text();
}

}  // namespace dorsum::accuracy
