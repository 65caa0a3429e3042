// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_detection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

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

// From a place to the top of the parabola through it and its neighbours.
float ShiftToTop(const std::vector<float>& r, std::size_t place) {
  const float curve = r[place - 1] - 2.0F * r[place] + r[place + 1];
  const float shift = curve < 0.0F ? 0.5F * (r[place - 1] - r[place + 1]) / curve : 0.0F;
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
void PartNeighbours(const std::vector<float>& response, int first, double width,
                    std::vector<RidgeCandidate>* found) {
  std::size_t kept = 0;
  for (const RidgeCandidate& c : *found) {
    if (kept > 0) {
      RidgeCandidate& last = (*found)[kept - 1];
      if (static_cast<double>(c.u - last.u) < 2.0 * width) {
        const auto from = response.begin() + std::lround(last.u) - first;
        const auto to = response.begin() + std::lround(c.u) + 1 - first;
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
  // Noise grows with the grey value, so what is no evidence on a black ground is none anywhere.
  const double least = std::max(options.min_response, 0.999 * std::sqrt(gain * noise.Variance(0.0)));

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
    const std::vector<float>& r = lines->response();
    std::vector<RidgeCandidate>& found = rows[static_cast<std::size_t>(row)];
    for (const int peak : lines->Peaks(static_cast<float>(least))) {
      const auto place = static_cast<std::size_t>(peak);
      const auto response = static_cast<double>(r[place]);
      if (in != nullptr && in[first + peak] == 0) continue;
      const double surroundings = std::max(0.0, static_cast<double>(lines->Smoothed(place)) - 0.5 * response);
      if (response * response < gain * noise.Variance(surroundings)) continue;
      const auto from = r.begin() + std::max(0, peak - reach);
      const auto to = r.begin() + std::min(end - first, peak + reach + 1);
      const float strongest = *std::max_element(from, to);
      if (response < options.min_share * static_cast<double>(strongest)) continue;
      found.push_back({static_cast<float>(first + peak) + ShiftToTop(r, place), r[place]});
    }
    PartNeighbours(r, first, options.width_px, &found);
  });
  return rows;
}

}  // namespace dorsum
