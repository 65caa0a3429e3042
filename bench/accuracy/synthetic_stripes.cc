// SPDX-License-Identifier: Apache-2.0
#include "synthetic_stripes.h"

#include "stripes/pooling.h"
#include "stripes/ridge.h"

namespace dorsum {

std::vector<SyntheticStripeCase> MeasureSyntheticStripes(std::uint64_t seed, const Context& context) {
  std::vector<SyntheticStripeCase> cases(3);
  cases[0].name = "40 clean";
  cases[1].name = "40 dim";
  cases[1].design.peak = 60.0;
  cases[1].design.noise_sd = 2.0;
  cases[2].name = "80 saturated";
  cases[2].design.stripes = 80;
  cases[2].design.peak = 400.0;
  for (SyntheticStripeCase& one : cases) {
    one.design.seed = seed;
    const SyntheticStripes scene = RenderSyntheticStripes(one.design);
    const LaserStripes rows = FindRidges(scene.image, cv::Mat(), 0, {}, context);
    one.single = ScoreSyntheticStripes(scene, rows);
    one.pooled = ScoreSyntheticStripes(scene, PoolAlongStripes(rows, {}, context));
  }
  return cases;
}

}  // namespace dorsum
