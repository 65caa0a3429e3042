// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_system.h"

#include <algorithm>

namespace dorsum {
namespace {

constexpr std::size_t RoundUp(std::size_t n) {
  return (n + PlateSystem::kBlock - 1) / PlateSystem::kBlock * PlateSystem::kBlock;
}

// Which of `upper` holds the neighbour.
enum Neighbour : std::size_t { kEast, kEastEast, kSouthWest, kSouth, kSouthEast, kSouthSouth };

// The weights of a plate's differences, each 0 where one of its nodes is not active: of z_xx and z_yy around
// a node, of z_xy over the cell that begins at it, and of the steps to its eastern and southern neighbours.
// Kept for the rows that one row of the matrix touches.
struct WeightRow {
  explicit WeightRow(std::size_t wide) : xx(wide), xy(wide), yy(wide), east(wide), south(wide) {}
  std::vector<float> xx, xy, yy, east, south;
};

void FillWeights(const PlateLattice& l, int r, float scale, float tension, WeightRow* out) {
  const auto frame = static_cast<std::size_t>(PlateSystem::kFrame);
  const int rows = l.active.rows, cols = l.active.cols;
  if (r < 0 || r >= rows) {
    for (auto* w : {&out->xx, &out->xy, &out->yy, &out->east, &out->south})
      std::fill(w->begin(), w->end(), 0.0F);
    return;
  }
  const auto* here = l.active.ptr<std::uint8_t>(r);
  const auto* above = r > 0 ? l.active.ptr<std::uint8_t>(r - 1) : nullptr;
  const auto* below = r + 1 < rows ? l.active.ptr<std::uint8_t>(r + 1) : nullptr;
  const auto* stiffness = l.stiffness.ptr<cv::Vec3f>(r);
  for (int c = 0; c < cols; ++c) {
    const bool on = here[c] != 0;
    const bool west = c > 0 && here[c - 1] != 0, east = on && c + 1 < cols && here[c + 1] != 0;
    const bool north = above != nullptr && above[c] != 0;
    const bool south = on && below != nullptr && below[c] != 0;
    const std::size_t i = static_cast<std::size_t>(c) + frame;
    out->xx[i] = west && east ? scale * stiffness[c][0] : 0.0F;
    out->xy[i] = east && south && below[c + 1] != 0 ? 2.0F * scale * stiffness[c][1] : 0.0F;
    out->yy[i] = north && south ? scale * stiffness[c][2] : 0.0F;
    out->east[i] = east ? tension : 0.0F;
    out->south[i] = south ? tension : 0.0F;
  }
}

}  // namespace

PlateSystem::PlateSystem(const PlateOptions& options, const PlateLattice& lattice)
    : cols_(RoundUp(static_cast<std::size_t>(lattice.active.cols + 2 * kFrame))) {
  // Behind the last row, what the solver reads beyond the end of a block.
  const std::size_t count = cols_ * static_cast<std::size_t>(lattice.active.rows + 2 * kFrame) + 4 * kBlock;
  diagonal.assign(count, 0.0F);
  for (auto& c : upper) c.assign(count, 0.0F);
  FindRuns(lattice.active);
  const double h = options.mm_per_px * lattice.step_px;
  const auto scale = static_cast<float>(1.0 / (h * h));
  const auto tension = static_cast<float>(options.tension);
  std::array<WeightRow, 3> rows = {WeightRow(cols_), WeightRow(cols_), WeightRow(cols_)};
  WeightRow *north = rows.data(), *here = &rows[1], *south = &rows[2];
  FillWeights(lattice, -1, scale, tension, north);
  FillWeights(lattice, 0, scale, tension, here);
  for (int r = 0; r < lattice.active.rows; ++r) {
    FillWeights(lattice, r + 1, scale, tension, south);
    const std::size_t row = At(-kFrame, r);
    const auto [begin, end] = spans_[static_cast<std::size_t>(r)];
    const float *xx = here->xx.data(), *xy = here->xy.data(), *yy = here->yy.data();
    const float *xy_north = north->xy.data(), *yy_north = north->yy.data(), *yy_south = south->yy.data();
    const float *to_east = here->east.data(), *to_south = here->south.data();
    const float* from_north = north->south.data();
    float *d = &diagonal[row], *east = &upper[kEast][row], *east_east = &upper[kEastEast][row];
    float *south_west = &upper[kSouthWest][row], *down = &upper[kSouth][row];
    float *south_east = &upper[kSouthEast][row], *south_south = &upper[kSouthSouth][row];
    const std::size_t first = std::max(begin, std::size_t{1}), last = std::min(end, cols_ - 1);
    for (std::size_t i = first; i < last; ++i) {
      d[i] = 4.0F * (xx[i] + yy[i]) + (xx[i - 1] + xx[i + 1]) + (yy_north[i] + yy_south[i]) +
             (xy[i - 1] + xy[i]) + (xy_north[i - 1] + xy_north[i]) +
             (to_east[i - 1] + to_east[i] + to_south[i] + from_north[i]);
      east[i] = -2.0F * (xx[i] + xx[i + 1]) - (xy_north[i] + xy[i]) - to_east[i];
      east_east[i] = xx[i + 1];
      south_west[i] = xy[i - 1];
      down[i] = -2.0F * (yy[i] + yy_south[i]) - (xy[i - 1] + xy[i]) - to_south[i];
      south_east[i] = xy[i];
      south_south[i] = yy_south[i];
    }
    std::swap(north, here);
    std::swap(here, south);
  }
}

void PlateSystem::FindRuns(const cv::Mat1b& active) {
  spans_.assign(static_cast<std::size_t>(active.rows), {});
  for (int r = 0; r < active.rows; ++r) {
    const auto* on = active.ptr<std::uint8_t>(r);
    const std::size_t row = At(-kFrame, r);
    auto& span = spans_[static_cast<std::size_t>(r)];
    for (int c = 0; c < active.cols; ++c) {
      if (on[c] == 0) continue;
      const std::size_t block = static_cast<std::size_t>(c + kFrame) / kBlock * kBlock;
      if (span.second == block + kBlock) continue;
      if (span.second == 0) span.first = block;
      span.second = block + kBlock;
      if (!runs_.empty() && runs_.back().second == row + block) {
        runs_.back().second += kBlock;
      } else {
        runs_.emplace_back(row + block, row + block + kBlock);
      }
    }
  }
}

void PlateSystem::AddSamples(std::span<const LatticePlace> places, std::span<const float> weights,
                             std::size_t each) {
  float *d = diagonal.data(), *east = upper[kEast].data(), *south = upper[kSouth].data();
  float *south_east = upper[kSouthEast].data(), *south_west = upper[kSouthWest].data();
  for (std::size_t k = 0; k < places.size(); k += each) {
    const LatticePlace& at = places[k];
    const float w = weights[k] * static_cast<float>(each);
    if (!at.known() || !(w > 0.0F)) continue;
    const std::size_t i = At(at.c, at.r), below = i + cols_;
    const float left = 1.0F - at.fc, top = 1.0F - at.fr;
    const float a = left * top, b = at.fc * top, c = left * at.fr, e = at.fc * at.fr;
    const float wa = w * a, wb = w * b, wc = w * c;
    d[i] += wa * a;
    d[i + 1] += wb * b;
    d[below] += wc * c;
    d[below + 1] += w * e * e;
    east[i] += wa * b;
    south[i] += wa * c;
    south_east[i] += wa * e;
    south_west[i + 1] += wb * c;
    south[i + 1] += wb * e;
    east[below] += wc * e;
  }
}

void PlateSystem::AddHeights(std::span<const float> heights, std::span<const LatticePlace> places,
                             std::span<const float> weights, std::vector<float>* right) const {
  float* out = right->data();
  for (std::size_t k = 0; k < places.size(); ++k) {
    const LatticePlace& at = places[k];
    const float w = weights[k];
    if (!at.known() || !(w > 0.0F)) continue;
    const std::size_t i = At(at.c, at.r), below = i + cols_;
    const float top = w * (1.0F - at.fr) * heights[k], bottom = w * at.fr * heights[k];
    out[i] += (1.0F - at.fc) * top;
    out[i + 1] += at.fc * top;
    out[below] += (1.0F - at.fc) * bottom;
    out[below + 1] += at.fc * bottom;
  }
}

// No coefficient of bending holds a node where it is: each row adds up to zero.
void PlateSystem::SubtractBending(const std::vector<float>& x, std::vector<float>* right) const {
  const std::array<std::ptrdiff_t, 6> offsets = Offsets();
  for (const auto& [begin, end] : runs_) {
    std::array<float, kBlock> sum;
    for (std::size_t block = begin; block < end; block += kBlock) {
      const float* here = &x[block];
      sum.fill(0.0F);
      for (std::size_t k = 0; k < offsets.size(); ++k) {
        const float *to = upper[k].data() + block, *from = to - offsets[k];
        const float *later = here + offsets[k], *earlier = here - offsets[k];
        for (std::size_t i = 0; i < kBlock; ++i) {
          sum[i] += to[i] * (later[i] - here[i]) + from[i] * (earlier[i] - here[i]);
        }
      }
      for (std::size_t i = 0; i < kBlock; ++i) (*right)[block + i] -= sum[i];
    }
  }
}

void PlateSystem::Finish() {
  inverse.assign(diagonal.size(), 0.0F);
  for (const auto& [begin, end] : runs_) {
    for (std::size_t i = begin; i < end; ++i) inverse[i] = diagonal[i] > 0.0F ? 1.0F / diagonal[i] : 0.0F;
  }
}

std::vector<float> PlateSystem::Gather(const PlateLattice& lattice) const {
  std::vector<float> x(size(), 0.0F);
  for (int r = 0; r < lattice.z.rows; ++r) {
    const auto* on = lattice.active.ptr<std::uint8_t>(r);
    const auto* z = lattice.z.ptr<float>(r);
    float* out = &x[At(0, r)];
    for (int c = 0; c < lattice.z.cols; ++c) out[c] = on[c] != 0 ? z[c] : 0.0F;
  }
  return x;
}

void PlateSystem::Scatter(const std::vector<float>& x, PlateLattice* lattice) const {
  for (int r = 0; r < lattice->z.rows; ++r) {
    const auto* on = lattice->active.ptr<std::uint8_t>(r);
    auto* z = lattice->z.ptr<float>(r);
    const float* in = &x[At(0, r)];
    for (int c = 0; c < lattice->z.cols; ++c) z[c] = on[c] != 0 ? in[c] : 0.0F;
  }
}

}  // namespace dorsum
