// SPDX-License-Identifier: Apache-2.0
#include "surface/rim.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr double kStepMm = 4.0;  // between the places at which the amplitude is found

struct Amplitude {
  double value = 0.0, information = 0.0;
};

struct Row {
  double du = 0.0, dv = 0.0, profile = 0.0, z = 0.0, weight = 0.0;
};

// Fits z = a + b du + c dv + amplitude * profile, robustly (Cauchy), and marginalises all but the amplitude.
Amplitude FitAmplitude(const std::vector<Row>& rows) {
  constexpr int kRounds = 4;
  constexpr double kScale = 0.4;  // mm; the model's own error
  Amplitude out;
  if (rows.size() < 12) return out;
  Eigen::Vector4d x = Eigen::Vector4d::Zero();
  Eigen::Matrix4d n = Eigen::Matrix4d::Zero();
  for (int round = 0; round < kRounds; ++round) {
    n.setZero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Row& r : rows) {
      const Eigen::Vector4d a(1.0, r.du, r.dv, r.profile);
      const double e = round == 0 ? 0.0 : (r.z - a.dot(x)) / kScale;
      const double w = r.weight / (1.0 + e * e);
      n += w * a * a.transpose();
      right += w * r.z * a;
    }
    n.diagonal() += Eigen::Vector4d(1e-6, 1e-3, 1e-3, 1e-3);
    x = n.ldlt().solve(right);
  }
  const Eigen::Matrix3d plane = n.topLeftCorner<3, 3>();
  const Eigen::Vector3d cross = n.topRightCorner<3, 1>();
  out.value = x[3];
  out.information = std::max(0.0, n(3, 3) - cross.dot(plane.ldlt().solve(cross)));
  return out;
}

}  // namespace

float Rim::Profile(double distance_px) const {
  const double d = std::clamp(distance_px * options_.mm_per_px, 0.0, options_.reach_mm);
  const double fade = 1.0 - d / options_.reach_mm;
  return static_cast<float>(std::sqrt(d) * fade * fade);
}

Rim::Rim(const std::vector<PlateSample>& samples, const Outline& outline, const RimOptions& options,
         const Context& context)
    : outline_(outline), options_(options) {
  const cv::Rect& b = outline.bounds();
  const double step_px = kStepMm / options.mm_per_px;
  amplitude_.u0 = b.x;
  amplitude_.v0 = b.y;
  amplitude_.step_px = step_px;
  const cv::Size size(static_cast<int>(b.width / step_px) + 2, static_cast<int>(b.height / step_px) + 2);
  amplitude_.active = cv::Mat1b(size, std::uint8_t{255});
  amplitude_.z = cv::Mat1f(size, 0.0F);

  const double reach = options.neighbourhood_mm / options.mm_per_px;
  std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(size.area()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlateSample& s = samples[i];
    const long c = std::lround((s.u - b.x) / step_px), r = std::lround((s.v - b.y) / step_px);
    if (c < 0 || r < 0 || c >= size.width || r >= size.height) continue;
    if (s.weight <= 0.0F || outline.Distance(s.u, s.v) * options.mm_per_px > options.reach_mm) continue;
    cells[static_cast<std::size_t>(r * size.width + c)].push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<Amplitude> found(cells.size());
  const int span = static_cast<int>(std::ceil(reach / step_px));
  ParallelFor(context, 0, size.height, [&](std::int64_t row) {
    std::vector<Row> rows;
    for (int c = 0; c < size.width; ++c) {
      const int r = static_cast<int>(row);
      const double u = amplitude_.U(c), v = amplitude_.V(r);
      if (std::abs(outline.Distance(u, v)) > step_px) continue;
      rows.clear();
      for (int y = std::max(0, r - span); y <= std::min(size.height - 1, r + span); ++y) {
        for (int x = std::max(0, c - span); x <= std::min(size.width - 1, c + span); ++x) {
          for (const std::uint32_t i : cells[static_cast<std::size_t>(y * size.width + x)]) {
            const PlateSample& s = samples[i];
            const double q = std::hypot(s.u - u, s.v - v) / reach;
            if (q >= 1.0) continue;
            rows.push_back({(s.u - u) * options.mm_per_px, (s.v - v) * options.mm_per_px,
                            Profile(outline.Distance(s.u, s.v)), s.z, (1.0 - q * q) * (1.0 - q * q)});
          }
        }
      }
      found[static_cast<std::size_t>(r * size.width + c)] = FitAmplitude(rows);
    }
  });
  // One step of averaging along the outline, weighted with what each place knows.
  // An amplitude is taken as zero as surely as 1 mm of a stripe's points with 0.2 mm of profile would say.
  const double prior = 0.2 / options.mm_per_px;
  for (int r = 0; r < size.height; ++r) {
    for (int c = 0; c < size.width; ++c) {
      double sum = 0.0, weight = prior;
      for (int y = std::max(0, r - 2); y <= std::min(size.height - 1, r + 2); ++y) {
        for (int x = std::max(0, c - 2); x <= std::min(size.width - 1, c + 2); ++x) {
          const Amplitude& a = found[static_cast<std::size_t>(y * size.width + x)];
          const double w = a.information * std::exp(-0.5 * ((x - c) * (x - c) + (y - r) * (y - r)));
          sum += w * a.value;
          weight += w;
        }
      }
      amplitude_.z(r, c) = static_cast<float>(sum / weight);
    }
  }
}

float Rim::Height(double u, double v) const {
  const float a = HeightAt(amplitude_, u, v);
  return std::isfinite(a) ? a * Profile(outline_.Distance(u, v)) : 0.0F;
}

}  // namespace dorsum
