// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_detection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/parallel.h"
#include "stripes/ridge_response.h"

namespace dorsum {
namespace {

// Half of the symmetric kernel, from its middle outwards: (G - mean G) / sum (G - mean G)^2.
std::vector<float> MatchedKernel(double width) {
  const int half = std::max(3, static_cast<int>(std::lround(3.0 * width)));
  std::vector<float> kernel(static_cast<std::size_t>(half) + 1);
  const auto gauss = [width](int i) { return std::exp(-0.5 * i * i / (width * width)); };
  double mean = 0.0, square = 0.0;
  for (int i = -half; i <= half; ++i) mean += gauss(i);
  mean /= 2.0 * half + 1.0;
  for (int i = -half; i <= half; ++i) square += (gauss(i) - mean) * (gauss(i) - mean);
  for (int i = 0; i <= half; ++i) {
    kernel[static_cast<std::size_t>(i)] = static_cast<float>((gauss(i) - mean) / square);
  }
  return kernel;
}

float Refine(const std::vector<float>& r, std::size_t u) {
  const float curve = r[u - 1] - 2.0F * r[u] + r[u + 1];
  const float shift = curve < 0.0F ? 0.5F * (r[u - 1] - r[u + 1]) / curve : 0.0F;
  return static_cast<float>(u) + std::clamp(shift, -0.5F, 0.5F);
}

// Drops the weaker of two that stand too close to be two.
void PartNeighbours(const std::vector<float>& response, double width, std::vector<RidgeCandidate>* found) {
  std::size_t kept = 0;
  for (const RidgeCandidate& c : *found) {
    if (kept > 0) {
      RidgeCandidate& last = (*found)[kept - 1];
      if (static_cast<double>(c.u - last.u) < 2.0 * width) {
        const auto from = response.begin() + std::lround(last.u);
        const auto to = response.begin() + std::lround(c.u) + 1;
        const float dip = *std::min_element(from, to);
        if (dip > 0.6F * std::min(c.response, last.response)) {
          if (c.response > last.response) last = c;
          continue;
        }
      }
    }
    (*found)[kept++] = c;
  }
  found->resize(kept);
}

}  // namespace

std::vector<std::vector<RidgeCandidate>> DetectRidges(const cv::Mat& green, const cv::Mat& region,
                                                      const NoiseModel& noise,
                                                      const RidgeDetectionOptions& options,
                                                      const Context& context, const RowComb& comb) {
  const std::vector<float> kernel = MatchedKernel(options.width_px);
  const double gain = NoiseGain(kernel) * options.min_contrast * options.min_contrast;
  const int reach = static_cast<int>(std::ceil(std::max(4.0 * options.width_px, 8.0)));

  std::vector<std::vector<RidgeCandidate>> rows(static_cast<std::size_t>(green.rows));
  const int count = std::max(0, (green.rows - comb.first + comb.step - 1) / comb.step);
  ParallelFor(context, 0, count, [&](std::int64_t i) {
    const std::int64_t row = comb.first + i * comb.step;
    thread_local std::optional<RidgeResponse> lines;
    if (!lines || lines->kernel() != kernel) lines.emplace(kernel);
    lines->Compute(green, static_cast<int>(row));
    const std::vector<float>& r = lines->response();
    const auto* in = region.empty() ? nullptr : region.ptr<std::uint8_t>(static_cast<int>(row));
    std::vector<RidgeCandidate>& found = rows[static_cast<std::size_t>(row)];
    for (const int peak : lines->Peaks(static_cast<float>(options.min_response))) {
      const auto u = static_cast<std::size_t>(peak);
      const auto response = static_cast<double>(r[u]);
      if (in != nullptr && in[u] == 0) continue;
      const double surroundings = std::max(0.0, static_cast<double>(lines->Smoothed(u)) - 0.5 * response);
      if (response * response < gain * noise.Variance(surroundings)) continue;
      const std::size_t from = u > static_cast<std::size_t>(reach) ? u - static_cast<std::size_t>(reach) : 0;
      const std::size_t to = std::min(r.size(), u + static_cast<std::size_t>(reach) + 1);
      const float strongest = *std::max_element(r.begin() + static_cast<std::ptrdiff_t>(from),
                                                r.begin() + static_cast<std::ptrdiff_t>(to));
      if (response < options.min_share * static_cast<double>(strongest)) continue;
      found.push_back({Refine(r, u), r[u]});
    }
    PartNeighbours(r, options.width_px, &found);
  });
  return rows;
}

}  // namespace dorsum
