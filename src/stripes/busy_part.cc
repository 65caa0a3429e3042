// SPDX-License-Identifier: Apache-2.0
#include "stripes/busy_part.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "stripes/ridge_survey.h"

namespace dorsum {
namespace {

constexpr int kCell = 8;  // px
static_assert(kSurveyedRows.step == kCell);

// Stripes that one laser shows on the empty backplane along a row.
struct Comb {
  int first = 0, last = 0;  // orders, from left to right
  int step = 1;             // from one to the next
  double apart_px = 0.0;    // usual distance of two
};

std::optional<Comb> CombOf(const DeviceOrders& orders, const LaserGeometry& laser, int row) {
  const double end = orders.device().camera.width - 1.0;
  const auto left = orders.At(laser.laser, 0.0, row), right = orders.At(laser.laser, end, row);
  if (!left || !right) return std::nullopt;
  const double a = left->OrderAt(0.0), b = right->OrderAt(0.0);
  if (!(std::abs(b - a) > 1.0)) return std::nullopt;
  Comb comb;
  comb.step = b > a ? 1 : -1;
  comb.apart_px = end / std::abs(b - a);
  // One that lies just within the picture's border may not be found.
  const double slack = 4.0 / comb.apart_px;
  const int low = std::max(laser.min_order, static_cast<int>(std::ceil(std::min(a, b) + slack)));
  const int high = std::min(laser.max_order, static_cast<int>(std::floor(std::max(a, b) - slack)));
  comb.first = comb.step > 0 ? low : high;
  comb.last = comb.step > 0 ? high : low;
  return comb;
}

// Marks the cells of a row that one laser does not show to be empty.
void MarkRow(std::span<const StripePoint> points, const LaserGeometry& laser, const DeviceOrders& orders,
             int row, const BusyPartOptions& options, std::span<std::uint8_t> cells) {
  const auto mark = [&](double from, double to) {
    const int first = std::max(0, static_cast<int>(from) / kCell);
    const int last = std::min(static_cast<int>(cells.size()) - 1, static_cast<int>(to) / kCell);
    for (int c = first; c <= last; ++c) cells[static_cast<std::size_t>(c)] = 255;
  };
  const double end = orders.device().camera.width - 1.0;
  const auto comb = CombOf(orders, laser, row);
  if (!comb) return mark(0.0, end);
  int next = comb->first;  // the stripe that should come now
  double since = 0.0;      // column from which it was to come
  for (const StripePoint& p : points) {
    const auto u = static_cast<double>(p.u);
    const auto ray = orders.At(laser.laser, u, row);
    const double order = ray ? ray->OrderAt(0.0) : 0.5;
    const double whole = std::round(order);
    if (std::abs(order - whole) * comb->apart_px > options.near_px) {
      mark(u - 0.5 * comb->apart_px, u + 0.5 * comb->apart_px);
      continue;
    }
    const int n = static_cast<int>(whole);
    const bool beyond = (n - comb->first) * comb->step < 0 || (n - comb->last) * comb->step > 0;
    if (!beyond && n != next) mark(since, u);
    if (!beyond) next = n + comb->step;
    since = u;
  }
  if ((comb->last - next) * comb->step >= 0) mark(since, end);
}

// Cells whose light has changed.
void MarkChanged(const cv::Mat& unchanged, cv::Mat1b* cells) {
  for (int v = 0; v < unchanged.rows; ++v) {
    const auto* row = unchanged.ptr<std::uint8_t>(v);
    auto* out = cells->ptr<std::uint8_t>((v + kCell - 1 - kSurveyedRows.first) / kCell);
    for (int u = 0; u < unchanged.cols; u = (u / kCell + 1) * kCell) {  // on with the next cell
      const void* changed = std::memchr(row + u, 0, static_cast<std::size_t>(unchanged.cols - u));
      if (changed == nullptr) break;
      u = static_cast<int>(static_cast<const std::uint8_t*>(changed) - row);
      out[u / kCell] = 255;
    }
  }
}

}  // namespace

cv::Mat FindBusyPart(const std::vector<LaserStripes>& surveyed, const DeviceOrders& orders,
                     const cv::Mat& unchanged, const BusyPartOptions& options, const Context& context) {
  // Row k of cells reaches from below surveyed row k - 1 to surveyed row k.
  const int count = std::max(0, (unchanged.rows - kSurveyedRows.first + kCell - 1) / kCell);
  const int cols = (unchanged.cols + kCell - 1) / kCell;
  cv::Mat1b cells(count + 1, cols, std::uint8_t{0});
  if (count == 0) {
    cv::Mat all(unchanged.size(), CV_8UC1, cv::Scalar(255));
    return all;
  }
  std::vector<cv::Mat1b> marked(surveyed.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(surveyed.size()), [&](std::int64_t i) {
    const LaserStripes& one = surveyed[static_cast<std::size_t>(i)];
    cv::Mat1b& rows = marked[static_cast<std::size_t>(i)];
    const LaserGeometry* laser = orders.device().FindLaser(one.laser);
    rows = cv::Mat1b(count, cols, static_cast<std::uint8_t>(laser == nullptr ? 255 : 0));
    auto next = one.points.begin();
    for (int k = 0; laser != nullptr && k < count; ++k) {
      const int row = kSurveyedRows.first + k * kCell;
      const auto first =
          std::find_if(next, one.points.end(), [&](const StripePoint& p) { return p.v >= row; });
      next = std::find_if(first, one.points.end(), [&](const StripePoint& p) { return p.v > row; });
      MarkRow({first, next}, *laser, orders, row, options,
              {rows.ptr<std::uint8_t>(k), static_cast<std::size_t>(cols)});
    }
  });
  for (const cv::Mat1b& rows : marked) {
    for (const int below : {0, 1}) {
      cv::Mat there = cells.rowRange(below, below + count);
      cv::bitwise_or(there, rows, there);
    }
  }
  MarkChanged(unchanged, &cells);
  const int side = 2 * options.margin_cells + 1;
  cv::dilate(cells, cells, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  cv::Mat large, out(unchanged.size(), CV_8UC1);
  cv::resize(cells, large, {cols * kCell, cells.rows * kCell}, 0, 0, cv::INTER_NEAREST);
  const cv::Rect part(0, kCell - 1 - kSurveyedRows.first, unchanged.cols, unchanged.rows);
  large(part).copyTo(out);
  return out;
}

}  // namespace dorsum
