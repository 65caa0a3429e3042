// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr float kFar = std::numeric_limits<float>::max();

// Lengths of the shortest ways over nodes that are `on`, in steps, from those where `way` is zero: sweeps
// with 3 x 3 masks until they change nothing (chamfer distances, Borgefors 1986).
void SpreadDistances(const cv::Mat1b& on, cv::Mat1f* way) {
  constexpr float kDiagonal = 1.4142136F;
  // With a frame, so that no border needs a test.
  cv::Mat1f d(way->rows + 2, way->cols + 2, kFar);
  way->copyTo(d(cv::Rect(1, 1, way->cols, way->rows)));
  // When each row was changed last, and swept last downwards and upwards: only what came after that matters.
  std::vector<int> changed(static_cast<std::size_t>(d.rows), 0);
  std::array<std::vector<int>, 2> swept;
  for (auto& when : swept) when.assign(changed.size(), -1);
  std::vector<float> across(static_cast<std::size_t>(d.cols));  // the shortest way over the row before
  int now = 0;
  for (bool any = true; any;) {
    any = false;
    for (const int sign : {-1, 1}) {
      for (int i = 0; i < way->rows; ++i) {
        const int r = sign < 0 ? i : way->rows - 1 - i;
        const auto row = static_cast<std::size_t>(r + 1), before_row = static_cast<std::size_t>(r + 1 + sign);
        int& last = swept[sign < 0 ? 0 : 1][row];
        if (std::max(changed[row], changed[before_row]) <= last) continue;
        last = now;
        const auto* known = on.ptr<std::uint8_t>(r) - 1;
        auto* here = d.ptr<float>(r + 1);
        const auto* before = d.ptr<float>(r + 1 + sign);
        auto* over = across.data();
        for (int c = 1; c <= way->cols; ++c)
          over[c] = std::min(before[c] + 1.0F, std::min(before[c - 1], before[c + 1]) + kDiagonal);
        for (int j = 0; j < way->cols; ++j) {
          const int c = sign < 0 ? j + 1 : way->cols - j;
          if (known[c] == 0) continue;
          const float least = std::min(here[c + sign] + 1.0F, over[c]);
          if (!(least < here[c])) continue;
          here[c] = least;
          changed[row] = now + 1;
        }
        if (changed[row] > now) {
          ++now;
          any = true;
        }
      }
    }
  }
  d(cv::Rect(1, 1, way->cols, way->rows)).copyTo(*way);
}

// Nodes inside the outline, and those with a neighbour inside.
cv::Mat1b NodesOnObject(const PlateLattice& l, const Outline& outline, cv::Size size,
                        const Context& context) {
  const cv::Mat inside = outline.AtNodes(l.u0, l.v0, l.step_px, size, context) > 0.0F;
  cv::Mat1b out;
  cv::dilate(inside, out, cv::Mat(3, 3, CV_8UC1, cv::Scalar(1)));
  return out;
}

}  // namespace

PlateLattice MakeSupport(const std::vector<PlateSample>& samples, const Outline& outline,
                         const PlateSupportOptions& options, const Context& context) {
  PlateLattice l;
  const cv::Rect& b = outline.bounds();
  l.step_px = options.step_px;
  l.u0 = b.x;
  l.v0 = b.y;
  const cv::Size size(static_cast<int>(b.width / l.step_px) + 2, static_cast<int>(b.height / l.step_px) + 2);
  const cv::Mat1b on = NodesOnObject(l, outline, size, context);
  cv::Mat1f to_sample(size, kFar);
  for (const PlateSample& s : samples) {
    const long c = std::lround((s.u - l.u0) / l.step_px), r = std::lround((s.v - l.v0) / l.step_px);
    if (s.weight <= 0.0F || c < 0 || r < 0 || c >= size.width || r >= size.height) continue;
    to_sample(static_cast<int>(r), static_cast<int>(c)) = 0.0F;
  }
  SpreadDistances(on, &to_sample);
  // A closing: what lies within half a gap of samples, less a rim, leaves the gaps closed and goes beyond the
  // last samples no further than asked.
  const double step_mm = l.step_px * options.mm_per_px;
  const double half_gap = 0.5 * options.max_gap_mm / step_mm, beyond = options.max_beyond_mm / step_mm;
  cv::Mat1f to_unseen(size, kFar);
  for (int r = 0; r < size.height; ++r) {
    for (int c = 0; c < size.width; ++c) {
      const bool border = r == 0 || c == 0 || r == size.height - 1 || c == size.width - 1;
      if (on(r, c) != 0 && (border || to_sample(r, c) > half_gap)) to_unseen(r, c) = 0.0F;
    }
  }
  SpreadDistances(on, &to_unseen);
  l.active = cv::Mat1b(size, std::uint8_t{0});
  l.z = cv::Mat1f(size, 0.0F);
  for (int r = 0; r < size.height; ++r) {
    for (int c = 0; c < size.width; ++c) {
      const bool seen =
          to_sample(r, c) <= beyond || (to_sample(r, c) <= half_gap && to_unseen(r, c) > half_gap - beyond);
      if (on(r, c) != 0 && seen) l.active(r, c) = 255;
    }
  }
  return l;
}

void StartFromMedians(const std::vector<PlateSample>& samples, const Context& context,
                      PlateLattice* lattice) {
  PlateLattice& l = *lattice;
  const auto cells = static_cast<std::size_t>(l.active.total());
  const auto cell_of = [&](const PlateSample& s) -> std::optional<std::size_t> {
    const long c = std::lround((s.u - l.u0) / l.step_px), r = std::lround((s.v - l.v0) / l.step_px);
    if (s.weight <= 0.0F || c < 0 || r < 0 || c >= l.active.cols || r >= l.active.rows) return std::nullopt;
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(l.active.cols) +
           static_cast<std::size_t>(c);
  };
  // The heights by cell: those of cell i end where those of the next begin.
  std::vector<std::uint32_t> ends(cells + 1, 0);
  for (const PlateSample& s : samples) {
    if (const auto cell = cell_of(s)) ++ends[*cell + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<float> heights(ends.back());
  for (const PlateSample& s : samples) {
    if (const auto cell = cell_of(s)) heights[ends[*cell]++] = s.z;  // and so the ends come about
  }
  const auto first_of = [&](std::size_t cell) { return cell == 0 ? 0U : ends[cell - 1]; };
  constexpr std::size_t kEnough = 10;
  constexpr int kMaxSpan = 8;
  ParallelFor(context, 0, l.active.rows, [&](std::int64_t row) {
    const int r = static_cast<int>(row);
    std::vector<float> around;
    for (int c = 0; c < l.active.cols; ++c) {
      if (l.active(r, c) == 0) continue;
      around.clear();
      for (int span = 1; span <= kMaxSpan && around.size() < kEnough; ++span) {
        around.clear();
        for (int y = std::max(0, r - span); y <= std::min(l.active.rows - 1, r + span); ++y) {
          // Neighbouring cells' heights follow each other.
          const std::size_t begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(l.active.cols);
          const auto west = begin + static_cast<std::size_t>(std::max(0, c - span));
          const auto east = begin + static_cast<std::size_t>(std::min(l.active.cols - 1, c + span));
          around.insert(around.end(), heights.begin() + first_of(west), heights.begin() + ends[east]);
        }
      }
      if (around.empty()) continue;
      const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
      std::nth_element(around.begin(), middle, around.end());
      l.z(r, c) = *middle;
    }
  });
}

}  // namespace dorsum
