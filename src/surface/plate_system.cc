// SPDX-License-Identifier: Apache-2.0
#include "surface/plate_system.h"

namespace dorsum {
namespace {

constexpr std::size_t RoundUp(std::size_t n) {
  return (n + PlateSystem::kBlock - 1) / PlateSystem::kBlock * PlateSystem::kBlock;
}

// Which of `upper` holds the neighbour.
enum Neighbour : int { kEast, kEastEast, kSouthWest, kSouth, kSouthEast, kSouthSouth };

}  // namespace

// Adds weight * (sum a_i z_i)^2; `neighbours` names how node j > i is seen from node i, pair by pair.
template <std::size_t N>
void PlateSystem::Add(const std::array<std::size_t, N>& at, const std::array<float, N>& a,
                      const std::array<int, N*(N - 1) / 2>& neighbours, float weight) {
  std::size_t pair = 0;
  for (std::size_t i = 0; i < N; ++i) {
    diagonal[at[i]] += weight * a[i] * a[i];
    for (std::size_t j = i + 1; j < N; ++j) {
      upper[static_cast<std::size_t>(neighbours[pair++])][at[i]] += weight * a[i] * a[j];
    }
  }
}

PlateSystem::PlateSystem(const PlateOptions& options, const PlateLattice& lattice)
    : cols_(RoundUp(static_cast<std::size_t>(lattice.active.cols + 2 * kFrame))) {
  const std::size_t count = cols_ * static_cast<std::size_t>(lattice.active.rows + 2 * kFrame);
  diagonal.assign(count, 0.0F);
  right.assign(count, 0.0F);
  for (auto& c : upper) c.assign(count, 0.0F);
  const double h = options.mm_per_px * lattice.step_px;
  const auto scale = static_cast<float>(1.0 / (h * h));
  const auto tension = static_cast<float>(options.tension);
  const int rows = lattice.active.rows, cols = lattice.active.cols;
  const std::size_t wide = cols_;
  for (int r = 0; r < rows; ++r) {
    const auto* here = lattice.active.ptr<std::uint8_t>(r);
    const auto* above = r > 0 ? lattice.active.ptr<std::uint8_t>(r - 1) : nullptr;
    const auto* below = r + 1 < rows ? lattice.active.ptr<std::uint8_t>(r + 1) : nullptr;
    const auto* stiffness = lattice.stiffness.ptr<cv::Vec3f>(r);
    for (int c = 0; c < cols; ++c) {
      if (here[c] == 0) continue;
      const std::size_t i = At(c, r);
      const bool west = c > 0 && here[c - 1] != 0, east = c + 1 < cols && here[c + 1] != 0;
      const bool north = above != nullptr && above[c] != 0, south = below != nullptr && below[c] != 0;
      if (west && east) {
        Add<3>({i - 1, i, i + 1}, {1.0F, -2.0F, 1.0F}, {kEast, kEastEast, kEast}, scale * stiffness[c][0]);
      }
      if (north && south) {
        Add<3>({i - wide, i, i + wide}, {1.0F, -2.0F, 1.0F}, {kSouth, kSouthSouth, kSouth},
               scale * stiffness[c][2]);
      }
      if (east && south && below[c + 1] != 0) {
        Add<4>({i, i + 1, i + wide, i + wide + 1}, {1.0F, -1.0F, -1.0F, 1.0F},
               {kEast, kSouth, kSouthEast, kSouthWest, kSouth, kEast}, 2.0F * scale * stiffness[c][1]);
      }
      if (east) Add<2>({i, i + 1}, {-1.0F, 1.0F}, {kEast}, tension);
      if (south) Add<2>({i, i + wide}, {-1.0F, 1.0F}, {kSouth}, tension);
    }
  }
}

void PlateSystem::AddSamples(const std::vector<PlateSample>& samples, const PlateLattice& lattice) {
  for (const PlateSample& p : samples) {
    const auto at = p.weight > 0.0F ? FindPlace(lattice, p.u, p.v) : std::nullopt;
    if (!at) continue;
    const std::size_t i = At(at->c, at->r), below = i + cols_;
    const std::array<std::size_t, 4> corners = {i, i + 1, below, below + 1};
    const std::array<float, 4> a = {(1 - at->fc) * (1 - at->fr), at->fc * (1 - at->fr), (1 - at->fc) * at->fr,
                                    at->fc * at->fr};
    Add<4>(corners, a, {kEast, kSouth, kSouthEast, kSouthWest, kSouth, kEast}, p.weight);
    for (std::size_t k = 0; k < 4; ++k) right[corners[k]] += p.weight * a[k] * p.z;
  }
}

void PlateSystem::Finish() {
  inverse.resize(diagonal.size());
  runs_.clear();
  for (std::size_t begin = 0; begin < diagonal.size(); begin += kBlock) {
    bool any = false;
    for (std::size_t i = begin; i < begin + kBlock; ++i) {
      any = any || diagonal[i] > 0.0F;
      inverse[i] = diagonal[i] > 0.0F ? 1.0F / diagonal[i] : 0.0F;
    }
    if (!any) continue;
    if (!runs_.empty() && runs_.back().second == begin) {
      runs_.back().second += kBlock;
    } else {
      runs_.emplace_back(begin, begin + kBlock);
    }
  }
}

}  // namespace dorsum
