// SPDX-License-Identifier: Apache-2.0
#include "stripes/ridge_detection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr std::array<float, 5> kRows = {0.0625F, 0.25F, 0.375F, 0.25F, 0.0625F};

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

// What one row needs; kept from row to row.
struct Lines {
  std::vector<float> padded, response;
};

void SmoothRows(const cv::Mat& green, int row, std::size_t pad, std::vector<float>* padded) {
  const auto cols = static_cast<std::size_t>(green.cols);
  padded->assign(cols + 2 * pad, 0.0F);
  float* to = padded->data() + pad;
  for (int k = -2; k <= 2; ++k) {
    const auto* from = green.ptr<std::uint8_t>(std::clamp(row + k, 0, green.rows - 1));
    const float weight = kRows[static_cast<std::size_t>(k + 2)];
    for (std::size_t u = 0; u < cols; ++u) to[u] += weight * static_cast<float>(from[u]);
  }
  std::fill(padded->begin(), padded->begin() + static_cast<std::ptrdiff_t>(pad), to[0]);
  std::fill(to + cols, to + cols + pad, to[cols - 1]);
}

void Filter(const std::vector<float>& kernel, std::size_t pad, Lines* lines) {
  const std::size_t cols = lines->padded.size() - 2 * pad;
  lines->response.resize(cols);
  const float* in = lines->padded.data() + pad;
  float* out = lines->response.data();
  for (std::size_t u = 0; u < cols; ++u) out[u] = kernel[0] * in[u];
  for (std::size_t k = 1; k < kernel.size(); ++k) {
    const float* right = in + k;
    const float* left = in - k;
    const float weight = kernel[k];
    for (std::size_t u = 0; u < cols; ++u) out[u] += weight * (left[u] + right[u]);
  }
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
  auto gain = static_cast<double>(kernel[0] * kernel[0]);
  for (std::size_t k = 1; k < kernel.size(); ++k) gain += 2.0 * static_cast<double>(kernel[k] * kernel[k]);
  double row_gain = 0.0;
  for (const float k : kRows) row_gain += static_cast<double>(k * k);
  gain *= row_gain * options.min_contrast * options.min_contrast;
  const std::size_t pad = kernel.size() - 1;
  const int reach = static_cast<int>(std::ceil(std::max(4.0 * options.width_px, 8.0)));

  std::vector<std::vector<RidgeCandidate>> rows(static_cast<std::size_t>(green.rows));
  const int count = std::max(0, (green.rows - comb.first + comb.step - 1) / comb.step);
  ParallelFor(context, 0, count, [&](std::int64_t i) {
    const std::int64_t row = comb.first + i * comb.step;
    thread_local Lines lines;
    SmoothRows(green, static_cast<int>(row), pad, &lines.padded);
    Filter(kernel, pad, &lines);
    const std::vector<float>& r = lines.response;
    const float* grey = lines.padded.data() + pad;
    const auto* in = region.empty() ? nullptr : region.ptr<std::uint8_t>(static_cast<int>(row));
    std::vector<RidgeCandidate>& found = rows[static_cast<std::size_t>(row)];
    for (std::size_t u = 1; u + 1 < r.size(); ++u) {
      if (!(r[u] > r[u - 1] && r[u] >= r[u + 1])) continue;
      const auto response = static_cast<double>(r[u]);
      if (response < options.min_response || (in != nullptr && in[u] == 0)) continue;
      const double surroundings = std::max(0.0, static_cast<double>(grey[u]) - 0.5 * response);
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
