// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_detection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "stripes/ridge_response.h"

namespace dorsum {
namespace {

// From a place to the top of the parabola through it and its neighbours.
float ShiftToTop(const std::vector<std::int16_t>& r, std::size_t place) {
  const int curve = r[place - 1] - 2 * r[place] + r[place + 1];
  const int lean = r[place - 1] - r[place + 1];
  const float shift = curve < 0 ? 0.5F * static_cast<float>(lean) / static_cast<float>(curve) : 0.0F;
  return std::clamp(shift, -0.5F, 0.5F);
}

// Columns [first, end) that hold all of a region in its row, and `reach` more on both sides; end is 0 where
// the region is empty.
std::pair<int, int> ColumnsOf(const std::uint8_t* region, int cols, int reach) {
  if (region == nullptr) return {0, cols};
  const auto is_in = [](std::uint8_t r) { return r != 0; };
  const std::uint8_t* first = std::find_if(region, region + cols, is_in);
  if (first == region + cols) return {0, 0};
  const auto last =
      std::find_if(std::make_reverse_iterator(region + cols), std::make_reverse_iterator(first), is_in);
  return {std::max(0, static_cast<int>(first - region) - reach),
          std::min(cols, static_cast<int>(last.base() - region) + reach)};
}

// Drops the weaker of two that stand too close to be two. `response` begins at column `first`.
void PartNeighbours(const std::vector<std::int16_t>& response, int first, double width,
                    std::vector<RidgeCandidate>* found) {
  std::size_t kept = 0;
  for (const RidgeCandidate& c : *found) {
    if (kept > 0) {
      RidgeCandidate& last = (*found)[kept - 1];
      if (static_cast<double>(c.u - last.u) < 2.0 * width) {
        const auto from = response.begin() + std::lround(last.u) - first;
        const auto to = response.begin() + std::lround(c.u) + 1 - first;
        const float dip = RidgeResponse::kUnit * static_cast<float>(*std::min_element(from, to));
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
  const RidgeKernel kernel = MakeRidgeKernel(options.width_px);
  const double gain = kernel.NoiseGain() * options.min_contrast * options.min_contrast;
  const int reach = static_cast<int>(std::ceil(std::max(4.0 * options.width_px, 8.0)));
  // Noise grows with the grey value, so what is no evidence on a black ground is none anywhere.
  const double least_grey = std::max(options.min_response, std::sqrt(gain * noise.Variance(0.0)));
  constexpr auto kUnit = static_cast<double>(RidgeResponse::kUnit);
  const auto least = static_cast<std::int16_t>(std::clamp(least_grey / kUnit, 1.0, 32767.0));

  std::vector<std::vector<RidgeCandidate>> rows(static_cast<std::size_t>(green.rows));
  const int count = std::max(0, (green.rows - comb.first + comb.step - 1) / comb.step);
  ParallelFor(context, 0, count, [&](std::int64_t i) {
    const int row = comb.first + static_cast<int>(i) * comb.step;
    const auto* in = region.empty() ? nullptr : region.ptr<std::uint8_t>(row);
    const auto [first, end] = ColumnsOf(in, green.cols, reach);
    if (end == 0) return;
    thread_local std::optional<RidgeResponse> lines;
    if (!lines || lines->kernel() != kernel) lines.emplace(kernel);
    lines->Compute(green, row, first, end);
    const std::vector<std::int16_t>& r = lines->response();
    std::vector<RidgeCandidate>& found = rows[static_cast<std::size_t>(row)];
    for (const int peak : lines->Peaks(least)) {
      const auto place = static_cast<std::size_t>(peak);
      const double response = kUnit * r[place];
      if (in != nullptr && in[first + peak] == 0) continue;
      const double surroundings = std::max(0.0, kUnit * lines->Smoothed(place) - 0.5 * response);
      if (response * response < gain * noise.Variance(surroundings)) continue;
      const auto from = r.begin() + std::max(0, peak - reach);
      const auto to = r.begin() + std::min(end - first, peak + reach + 1);
      const std::int16_t strongest =
          std::accumulate(from, to, r[place], [](std::int16_t a, std::int16_t b) { return std::max(a, b); });
      if (response < options.min_share * kUnit * strongest) continue;
      found.push_back(
          {static_cast<float>(first + peak) + ShiftToTop(r, place), static_cast<float>(response)});
    }
    PartNeighbours(r, first, options.width_px, &found);
  });
  return rows;
}

}  // namespace dorsum
