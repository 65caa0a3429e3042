// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_combs.h"

#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

double Circular(double a, double b) {
  const double d = a - b;
  return std::abs(d - std::round(d));
}

// Sums over the points of the grid.
struct Sums {
  std::vector<double> lit, apart;  // by laser; by pair a * lasers + b
  double seen = 0.0, any = 0.0, all = 0.0, common = 0.0, spacing = 0.0, gap = 0.0;
};

void AddPoint(const std::vector<PointFigures>& at, Sums* sums) {
  const std::size_t lasers = at.size();
  std::size_t lit = 0;
  for (std::size_t k = 0; k < lasers; ++k) {
    if (!at[k].lit) continue;
    sums->lit[k] += 1.0;
    ++lit;
  }
  sums->any += lit > 0 ? 1.0 : 0.0;
  if (lit < lasers) return;
  sums->all += 1.0;
  std::vector<double> phase;
  phase.reserve(lasers);
  for (const PointFigures& f : at) phase.push_back(f.order - std::floor(f.order));
  for (std::size_t a = 0; a < lasers; ++a) {
    for (std::size_t b = a + 1; b < lasers; ++b) sums->apart[a * lasers + b] += Circular(phase[a], phase[b]);
  }
  std::sort(phase.begin(), phase.end());
  double gap = phase.front() + 1.0 - phase.back();
  for (std::size_t k = 1; k < lasers; ++k) gap = std::max(gap, phase[k] - phase[k - 1]);
  sums->gap += gap * at.front().spacing_mm;
  sums->spacing += at.front().spacing_mm;
}

}  // namespace

CombFigures FindCombs(const DesignedDevice& device, double height_mm, int columns, int rows) {
  const std::size_t lasers = device.lasers.size();
  Sums sums;
  sums.lit.assign(lasers, 0.0);
  sums.apart.assign(lasers * lasers, 0.0);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Eigen::Vector2d share((c + 0.5) / columns, (r + 0.5) / rows);
      const Eigen::Vector2d xy = device.hand.min() + share.cwiseProduct(device.hand.sizes());
      std::vector<PointFigures> at;
      at.reserve(lasers);
      for (const DesignedLaser& laser : device.lasers) {
        at.push_back(FiguresAt(device, laser, {xy.x(), xy.y(), height_mm}).value_or(PointFigures{}));
      }
      if (!at.front().seen) continue;
      sums.seen += 1.0;
      AddPoint(at, &sums);
    }
  }
  CombFigures out;
  const double points = 1.0 * columns * rows;
  out.height_mm = height_mm;
  out.seen = sums.seen / points;
  for (const double lit : sums.lit) out.coverage.push_back(lit / points);
  out.any_coverage = sums.any / points;
  out.all_coverage = sums.all / points;
  if (sums.all == 0.0) return out;
  out.spacing_mm = sums.spacing / sums.all;
  out.largest_gap_mm = sums.gap / sums.all;
  for (std::size_t a = 0; a < lasers; ++a) {
    for (std::size_t b = a + 1; b < lasers; ++b) {
      const double apart = sums.apart[a * lasers + b] / sums.all;
      if (apart >= out.closest) continue;
      out.closest = apart;
      out.closest_a = static_cast<int>(a);
      out.closest_b = static_cast<int>(b);
    }
  }
  return out;
}

std::vector<CombFigures> FindCombs(const DesignedDevice& device, int count) {
  const auto& [low, high] = device.description.working_heights_mm;
  std::vector<CombFigures> out;
  out.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    out.push_back(FindCombs(device, low + (high - low) * i / std::max(1, count - 1)));
  }
  return out;
}

}  // namespace dorsum
