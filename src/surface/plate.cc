// SPDX-License-Identifier: Apache-2.0
#include "surface/plate.h"

#include <limits>

#include "surface/plate_solver.h"
#include "surface/plate_stack.h"

namespace dorsum {

LatticePlace FindPlace(const PlateLattice& l, double u, double v) {
  const double x = (u - l.u0) / l.step_px, y = (v - l.v0) / l.step_px;
  if (!(x >= 0.0 && y >= 0.0 && x < l.active.cols - 1 && y < l.active.rows - 1)) return {};
  LatticePlace out;
  out.c = static_cast<int>(x);
  out.r = static_cast<int>(y);
  out.fc = static_cast<float>(x - out.c);
  out.fr = static_cast<float>(y - out.r);
  const std::uint8_t* top = l.active.ptr(out.r) + out.c;
  const std::uint8_t* bottom = l.active.ptr(out.r + 1) + out.c;
  if (top[0] == 0 || top[1] == 0 || bottom[0] == 0 || bottom[1] == 0) return {};
  return out;
}

std::vector<LatticePlace> FindPlaces(const PlateLattice& lattice, const std::vector<PlateSample>& samples) {
  std::vector<LatticePlace> out;
  out.reserve(samples.size());
  for (const PlateSample& s : samples) out.push_back(FindPlace(lattice, s.u, s.v));
  return out;
}

int SolvePlate(const std::vector<PlateSample>& samples, const PlateOptions& options, PlateLattice* lattice) {
  const std::vector<PlateGrid> grids = MakeGrids(*lattice, options.mm_per_px, samples);
  std::vector<float> weights, heights;
  for (const PlateSample& s : samples) {
    weights.push_back(s.weight);
    heights.push_back(s.z);
  }
  PlateStack stack(options, grids);
  stack.SetSamples(weights, grids);
  PlateSolver solver;
  return stack.Solve(heights, weights, grids[0], options, &solver, lattice);
}

PlateLattice Coarsen(const PlateLattice& fine) {
  PlateLattice out;
  out.u0 = fine.u0;
  out.v0 = fine.v0;
  out.step_px = 2.0 * fine.step_px;
  out.active = cv::Mat1b((fine.active.rows + 2) / 2 + 1, (fine.active.cols + 2) / 2 + 1, std::uint8_t{0});
  out.z = cv::Mat1f(out.active.size(), 0.0F);
  for (int r = 0; r < fine.active.rows; ++r) {
    const auto* on = fine.active.ptr<std::uint8_t>(r);
    auto *north = out.active.ptr<std::uint8_t>(r / 2), *south = out.active.ptr<std::uint8_t>((r + 1) / 2);
    for (int c = 0; c < fine.active.cols; ++c) {
      if (on[c] == 0) continue;
      north[c / 2] = north[(c + 1) / 2] = 255;
      south[c / 2] = south[(c + 1) / 2] = 255;
    }
  }
  return out;
}

void Prolong(const PlateLattice& coarse, PlateLattice* fine) {
  for (int r = 0; r < fine->active.rows; ++r) {
    const auto* on = fine->active.ptr<std::uint8_t>(r);
    const auto *north = coarse.z.ptr<float>(r / 2), *south = coarse.z.ptr<float>((r + 1) / 2);
    auto* out = fine->z.ptr<float>(r);
    for (int c = 0; c < fine->active.cols; ++c) {
      if (on[c] == 0) continue;
      const int c0 = c / 2, c1 = (c + 1) / 2;
      out[c] = 0.25F * (north[c0] + north[c1] + south[c0] + south[c1]);
    }
  }
}

float HeightAt(const PlateLattice& lattice, const LatticePlace& place) {
  if (!place.known()) return std::numeric_limits<float>::quiet_NaN();
  const float* top = lattice.z.ptr<float>(place.r) + place.c;
  const float* bottom = lattice.z.ptr<float>(place.r + 1) + place.c;
  const float a = top[0] + place.fc * (top[1] - top[0]), b = bottom[0] + place.fc * (bottom[1] - bottom[0]);
  return a + place.fr * (b - a);
}

float HeightAt(const PlateLattice& lattice, double u, double v) {
  return HeightAt(lattice, FindPlace(lattice, u, v));
}

}  // namespace dorsum
