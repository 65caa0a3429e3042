// SPDX-License-Identifier: Apache-2.0
#include "surface/rim.h"

#include <algorithm>
#include <array>
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
  Eigen::Matrix4d n;
  for (int round = 0; round < kRounds; ++round) {
    // The upper half of the normal equations, then the right side.
    std::array<double, 14> s{};
    for (const Row& r : rows) {
      const double e = r.z - (x[0] + x[1] * r.du + x[2] * r.dv + x[3] * r.profile);
      const double w = round == 0 ? r.weight : r.weight / (1.0 + e * e / (kScale * kScale));
      const double u = w * r.du, v = w * r.dv, p = w * r.profile;
      const std::array<double, 14> terms = {w,
                                            u,
                                            v,
                                            p,
                                            u * r.du,
                                            u * r.dv,
                                            u * r.profile,
                                            v * r.dv,
                                            v * r.profile,
                                            p * r.profile,
                                            w * r.z,
                                            u * r.z,
                                            v * r.z,
                                            p * r.z};
      for (std::size_t i = 0; i < terms.size(); ++i) s[i] += terms[i];
    }
    n << s[0], s[1], s[2], s[3], s[1], s[4], s[5], s[6], s[2], s[5], s[7], s[8], s[3], s[6], s[8], s[9];
    n.diagonal() += Eigen::Vector4d(1e-6, 1e-3, 1e-3, 1e-3);
    x = n.ldlt().solve(Eigen::Vector4d(s[10], s[11], s[12], s[13]));
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
  std::vector<float> distances(samples.size()), profiles(samples.size(), 0.0F);
  ParallelFor(context, 0, static_cast<std::int64_t>(samples.size()), [&](std::int64_t i) {
    const PlateSample& s = samples[static_cast<std::size_t>(i)];
    distances[static_cast<std::size_t>(i)] = outline.Distance(s.u, s.v);
  });
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlateSample& s = samples[i];
    const long c = std::lround((s.u - b.x) / step_px), r = std::lround((s.v - b.y) / step_px);
    if (c < 0 || r < 0 || c >= size.width || r >= size.height) continue;
    if (s.weight <= 0.0F) continue;
    const float distance = distances[i];
    if (distance * options.mm_per_px > options.reach_mm) continue;
    profiles[i] = Profile(distance);
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
            const double du = s.u - u, dv = s.v - v, rest = 1.0 - (du * du + dv * dv) / (reach * reach);
            if (rest <= 0.0) continue;
            rows.push_back({du * options.mm_per_px, dv * options.mm_per_px, profiles[i], s.z, rest * rest});
          }
        }
      }
      found[static_cast<std::size_t>(r * size.width + c)] = FitAmplitude(rows);
    }
  });
  // One step of averaging along the outline, weighted with what each place knows.
  // An amplitude is taken as zero as surely as 1 mm of a stripe's points with 0.2 mm of profile would say.
  const double prior = 0.2 / options.mm_per_px;
  std::array<double, 9> near{};  // by the square of the distance
  for (std::size_t i = 0; i < near.size(); ++i) near[i] = std::exp(-0.5 * static_cast<double>(i));
  for (int r = 0; r < size.height; ++r) {
    for (int c = 0; c < size.width; ++c) {
      double sum = 0.0, weight = prior;
      for (int y = std::max(0, r - 2); y <= std::min(size.height - 1, r + 2); ++y) {
        for (int x = std::max(0, c - 2); x <= std::min(size.width - 1, c + 2); ++x) {
          const Amplitude& a = found[static_cast<std::size_t>(y * size.width + x)];
          const double w =
              a.information * near[static_cast<std::size_t>((x - c) * (x - c) + (y - r) * (y - r))];
          sum += w * a.value;
          weight += w;
        }
      }
      amplitude_.z(r, c) = static_cast<float>(sum / weight);
    }
  }
}

float Rim::Height(double u, double v) const {
  const float profile = Profile(outline_.Distance(u, v));
  if (profile == 0.0F) return 0.0F;  // most of a hand is out of reach
  const float a = HeightAt(amplitude_, u, v);
  return std::isfinite(a) ? a * profile : 0.0F;
}

}  // namespace dorsum
