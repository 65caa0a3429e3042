// SPDX-License-Identifier: Apache-2.0
#include "surface/plate.h"

#include <limits>

#include "surface/plate_system.h"

namespace dorsum {

std::optional<LatticePlace> FindPlace(const PlateLattice& l, double u, double v) {
  const double x = (u - l.u0) / l.step_px, y = (v - l.v0) / l.step_px;
  if (!(x >= 0.0 && y >= 0.0 && x < l.active.cols - 1 && y < l.active.rows - 1)) return std::nullopt;
  LatticePlace out;
  out.c = static_cast<int>(x);
  out.r = static_cast<int>(y);
  out.fc = static_cast<float>(x - out.c);
  out.fr = static_cast<float>(y - out.r);
  const std::uint8_t* top = l.active.ptr(out.r) + out.c;
  const std::uint8_t* bottom = l.active.ptr(out.r + 1) + out.c;
  if (top[0] == 0 || top[1] == 0 || bottom[0] == 0 || bottom[1] == 0) return std::nullopt;
  return out;
}

int SolvePlate(const std::vector<PlateSample>& samples, const PlateOptions& options, PlateLattice* lattice) {
  PlateLattice& l = *lattice;
  PlateSystem s(options, l);
  s.AddSamples(samples, l);
  s.Finish();
  std::vector<float> x(s.size(), 0.0F);
  for (int r = 0; r < l.z.rows; ++r) {
    for (int c = 0; c < l.z.cols; ++c) x[s.At(c, r)] = l.active(r, c) != 0 ? l.z(r, c) : 0.0F;
  }
  const int iterations = SolveByGradients(s, options.max_iterations, options.tolerance, &x);
  for (int r = 0; r < l.z.rows; ++r) {
    for (int c = 0; c < l.z.cols; ++c) l.z(r, c) = l.active(r, c) != 0 ? x[s.At(c, r)] : 0.0F;
  }
  return iterations;
}

PlateLattice Coarsen(const PlateLattice& fine) {
  PlateLattice out;
  out.u0 = fine.u0;
  out.v0 = fine.v0;
  out.step_px = 2.0 * fine.step_px;
  out.active = cv::Mat1b((fine.active.rows + 2) / 2 + 1, (fine.active.cols + 2) / 2 + 1, std::uint8_t{0});
  out.z = cv::Mat1f(out.active.size(), 0.0F);
  for (int r = 0; r < fine.active.rows; ++r) {
    for (int c = 0; c < fine.active.cols; ++c) {
      if (fine.active(r, c) == 0) continue;
      for (int y = r / 2; y <= (r + 1) / 2; ++y) {
        for (int x = c / 2; x <= (c + 1) / 2; ++x) out.active(y, x) = 255;
      }
    }
  }
  return out;
}

void Prolong(const PlateLattice& coarse, PlateLattice* fine) {
  for (int r = 0; r < fine->active.rows; ++r) {
    for (int c = 0; c < fine->active.cols; ++c) {
      if (fine->active(r, c) == 0) continue;
      const int r0 = r / 2, r1 = (r + 1) / 2, c0 = c / 2, c1 = (c + 1) / 2;
      fine->z(r, c) = 0.25F * (coarse.z(r0, c0) + coarse.z(r0, c1) + coarse.z(r1, c0) + coarse.z(r1, c1));
    }
  }
}

float HeightAt(const PlateLattice& lattice, double u, double v) {
  const auto at = FindPlace(lattice, u, v);
  if (!at) return std::numeric_limits<float>::quiet_NaN();
  const float* top = lattice.z.ptr<float>(at->r) + at->c;
  const float* bottom = lattice.z.ptr<float>(at->r + 1) + at->c;
  const float a = top[0] + at->fc * (top[1] - top[0]), b = bottom[0] + at->fc * (bottom[1] - bottom[0]);
  return a + at->fr * (b - a);
}

}  // namespace dorsum
