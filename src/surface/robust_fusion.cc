// SPDX-License-Identifier: Apache-2.0
#include "surface/robust_fusion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "surface/lattice_mesh.h"
#include "surface/outline.h"
#include "surface/plate.h"
#include "surface/rim.h"

namespace dorsum {
namespace {

constexpr float kLeastSigma = 0.01F;  // mm; no point is better than that

// How many mm of the object one pixel spans, at the points' median depth.
double MmPerPixel(const SurfacePoints& points, const Camera& camera) {
  std::vector<double> depths;
  depths.reserve(points.size());
  for (const SurfacePoint& p : points) depths.push_back((camera.camera_from_world * p.position).z());
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle / std::sqrt(camera.fx * camera.fy);
}

std::vector<PlateSample> MakeSamples(const SurfacePoints& points) {
  std::vector<PlateSample> samples;
  samples.reserve(points.size());
  for (const SurfacePoint& p : points) {
    const float sigma = std::max(p.sigma, kLeastSigma);
    samples.push_back({p.u, p.v, static_cast<float>(p.position.z()), 1.0F / (sigma * sigma)});
  }
  return samples;
}

// Lattice nodes on the object or next to it that have a point within reach.
PlateLattice MakeLattice(const std::vector<PlateSample>& samples, const Outline& outline, double step_px,
                         double reach_px) {
  PlateLattice l;
  const cv::Rect& b = outline.bounds();
  l.step_px = step_px;
  l.u0 = b.x;
  l.v0 = b.y;
  const cv::Size size(static_cast<int>(b.width / step_px) + 2, static_cast<int>(b.height / step_px) + 2);
  cv::Mat1b empty(size, std::uint8_t{255});
  for (const PlateSample& s : samples) {
    const long c = std::lround((s.u - l.u0) / step_px), r = std::lround((s.v - l.v0) / step_px);
    if (c >= 0 && r >= 0 && c < size.width && r < size.height)
      empty(static_cast<int>(r), static_cast<int>(c)) = 0;
  }
  cv::Mat1f distance;
  cv::distanceTransform(empty, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  l.active = cv::Mat1b(size, std::uint8_t{0});
  l.z = cv::Mat1f(size, 0.0F);
  for (int r = 0; r < size.height; ++r) {
    for (int c = 0; c < size.width; ++c) {
      const bool on = outline.Distance(l.U(c), l.V(r)) > -1.5 * step_px;
      if (on && distance(r, c) * step_px <= reach_px) l.active(r, c) = 255;
    }
  }
  return l;
}

// Medians of the samples around each node: a start that outliers in the minority do not reach.
void StartFromMedians(const std::vector<PlateSample>& samples, PlateLattice* l) {
  std::vector<std::vector<float>> cells(l->active.total());
  const auto cell = [&](int c, int r) -> std::vector<float>& {
    return cells[static_cast<std::size_t>(r) * static_cast<std::size_t>(l->active.cols) +
                 static_cast<std::size_t>(c)];
  };
  for (const PlateSample& s : samples) {
    const long c = std::lround((s.u - l->u0) / l->step_px), r = std::lround((s.v - l->v0) / l->step_px);
    if (c >= 0 && r >= 0 && c < l->active.cols && r < l->active.rows)
      cell(static_cast<int>(c), static_cast<int>(r)).push_back(s.z);
  }
  std::vector<float> around;
  for (int r = 0; r < l->active.rows; ++r) {
    for (int c = 0; c < l->active.cols; ++c) {
      if (l->active(r, c) == 0) continue;
      for (int span = 1; span <= 4; ++span) {
        around.clear();
        for (int y = std::max(0, r - span); y <= std::min(l->active.rows - 1, r + span); ++y) {
          for (int x = std::max(0, c - span); x <= std::min(l->active.cols - 1, c + span); ++x) {
            around.insert(around.end(), cell(x, y).begin(), cell(x, y).end());
          }
        }
        if (around.size() < 10 && span < 4) continue;
        if (around.empty()) break;
        const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
        std::nth_element(around.begin(), middle, around.end());
        l->z(r, c) = *middle;
        break;
      }
    }
  }
}

// Geman and McClure's weights for the residuals against the present surface.
std::vector<PlateSample> Reweigh(const std::vector<PlateSample>& samples, const PlateLattice& l,
                                 double scale_mm, double sigmas) {
  std::vector<PlateSample> out = samples;
  for (PlateSample& s : out) {
    const float z = HeightAt(l, s.u, s.v);
    if (!std::isfinite(z)) continue;
    const double scale = std::max(scale_mm, sigmas / std::sqrt(static_cast<double>(s.weight)));
    const double e = (s.z - z) / scale;
    s.weight = static_cast<float>(s.weight / ((1.0 + e * e) * (1.0 + e * e)));
  }
  return out;
}

}  // namespace

RobustFusion FuseRobust(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
                        const RobustFusionOptions& options, const Context& context) {
  RobustFusion out;
  out.field.pitch_mm = options.pitch_mm;
  out.verdicts.assign(points.size(), PointVerdict::kGood);
  if (points.empty()) return out;
  const double mm_per_px = MmPerPixel(points, camera);
  const double step = options.pitch_mm / mm_per_px;
  const Outline outline(mask, static_cast<int>(std::ceil(2.0 * step)) + 1);
  std::vector<PlateSample> samples = MakeSamples(points);

  std::vector<PlateLattice> levels = {
      MakeLattice(samples, outline, step, options.max_distance_mm / mm_per_px)};
  while (levels.back().step_px * mm_per_px < 2.0) levels.push_back(Coarsen(levels.back()));
  std::reverse(levels.begin(), levels.end());

  PlateOptions plate;
  plate.mm_per_px = mm_per_px;
  plate.stiffness = options.stiffness;
  StartFromMedians(samples, levels.data());
  for (const double scale : {8.0, 4.0, 2.5}) {
    const std::vector<PlateSample> weighed = Reweigh(samples, levels[0], scale, options.outlier_sigmas);
    SolvePlate(weighed, plate, levels.data(), context);
  }
  const Rim rim(Reweigh(samples, levels[0], 2.5, options.outlier_sigmas), outline, {.mm_per_px = mm_per_px},
                context);
  for (PlateSample& s : samples) s.z -= rim.Height(s.u, s.v);
  for (int r = 0; r < levels[0].z.rows; ++r) {
    for (int c = 0; c < levels[0].z.cols; ++c)
      levels[0].z(r, c) -= rim.Height(levels[0].U(c), levels[0].V(r));
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (i > 0) Prolong(levels[i - 1], &levels[i]);
    const double scale = std::max(1.0, 0.6 * levels[i].step_px * mm_per_px);
    for (int round = 0; round < 2; ++round) {
      const std::vector<PlateSample> weighed = Reweigh(samples, levels[i], scale, options.outlier_sigmas);
      SolvePlate(weighed, plate, &levels[i], context);
    }
  }
  PlateLattice& finest = levels.back();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float z = HeightAt(finest, samples[i].u, samples[i].v);
    if (!std::isfinite(z)) {
      out.verdicts[i] = PointVerdict::kOutsideSupport;
      continue;
    }
    const double limit = std::max(options.outlier_mm,
                                  options.outlier_sigmas / std::sqrt(static_cast<double>(samples[i].weight)));
    if (std::abs(samples[i].z - z) <= limit) continue;
    out.verdicts[i] = PointVerdict::kOutlier;
    ++out.outliers;
  }
  for (int r = 0; r < finest.z.rows; ++r) {
    for (int c = 0; c < finest.z.cols; ++c) finest.z(r, c) += rim.Height(finest.U(c), finest.V(r));
  }
  out.mesh = MeshLattice(finest, outline, camera, options.max_slope_deg);
  out.field = RasterizeMesh(out.mesh, options.pitch_mm);
  out.field.left_out = out.outliers;
  return out;
}

}  // namespace dorsum
