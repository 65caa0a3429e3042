// SPDX-License-Identifier: Apache-2.0
#include "surface/sample_weights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/parallel.h"

namespace dorsum {

std::vector<float> Heights(const std::vector<PlateSample>& samples) {
  std::vector<float> out;
  out.reserve(samples.size());
  for (const PlateSample& s : samples) out.push_back(s.z);
  return out;
}

void SetWeights(const std::vector<float>& weights, std::vector<PlateSample>* samples) {
  for (std::size_t i = 0; i < weights.size(); ++i) (*samples)[i].weight = weights[i];
}

std::vector<float> Reweigh(const std::vector<PlateSample>& samples, const PlateGrid& grid, double scale_mm,
                           double sigmas, const Context& context) {
  constexpr std::size_t kTogether = 2048;
  std::vector<float> out(samples.size());
  ParallelFor(context, 0, static_cast<std::int64_t>((samples.size() + kTogether - 1) / kTogether),
              [&](std::int64_t block) {
                const std::size_t first = static_cast<std::size_t>(block) * kTogether;
                for (std::size_t i = first; i < std::min(samples.size(), first + kTogether); ++i) {
                  const PlateSample& s = samples[i];
                  out[i] = s.weight;
                  const float z = HeightAt(grid.lattice, grid.places[i]);
                  if (s.weight <= 0.0F || !std::isfinite(z)) continue;
                  const double scale = std::max(scale_mm, sigmas / std::sqrt(static_cast<double>(s.weight)));
                  const double e = (s.z - z) / scale;
                  out[i] = static_cast<float>(s.weight / ((1.0 + e * e) * (1.0 + e * e)));
                }
              });
  return out;
}

}  // namespace dorsum
