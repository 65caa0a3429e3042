// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_field.h"

#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

// Image rows to a millimetre along the stripe, on a level surface.
double RowsPerMm(const Camera& camera, const Eigen::Vector3d& point) {
  const Eigen::Vector3d aside(0.0, 0.5, 0.0);
  return std::abs(Project(camera, point + aside).y() - Project(camera, point - aside).y());
}

struct Mean {
  double sum = 0.0, weight = 0.0;
  void Add(double value) {
    sum += value;
    weight += 1.0;
  }
  double Value() const { return weight > 0.0 ? sum / weight : 0.0; }
};

}  // namespace

std::vector<FieldSample> SampleField(const DesignedDevice& device, int laser, double height_mm,
                                     const SurfaceAssumption& surface, int count) {
  const DesignedLaser& source = device.lasers.at(static_cast<std::size_t>(laser));
  std::vector<FieldSample> out;
  for (int i = 0; i < count; ++i) {
    const double share = i / std::max(1.0, count - 1.0);
    const Eigen::Vector3d point(device.hand.min().x() + share * device.hand.sizes().x(),
                                device.hand.center().y(), height_mm);
    const auto f = FiguresAt(device, source, point);
    if (!f) continue;
    FieldSample s;
    s.x_mm = point.x();
    s.order = f->order;
    s.used = f->lit && f->seen;
    s.spacing_mm = f->spacing_mm;
    s.spacing_px = f->SpacingPx();
    s.depth_mm_per_px = f->DepthPerPx();
    const StripeProfile profile = ProfileAt(device, source, point, *f, surface);
    const CentreNoise noise =
        StripeCentreNoise(profile, device.description.sensor, device.description.speckle);
    s.width_px = profile.core_sigma_px;
    s.peak = profile.core_peak + profile.wide_peak;
    s.row_sigma_mm = noise.row_px * s.depth_mm_per_px;
    s.pooled_sigma_mm = noise.PooledPx(surface.pooled_rows, device.description.speckle) * s.depth_mm_per_px;
    out.push_back(s);
  }
  return out;
}

VolumeFigures JudgeVolume(const DesignedDevice& device, int laser, const SurfaceAssumption& surface,
                          int columns, int rows, int heights) {
  const DesignedLaser& source = device.lasers.at(static_cast<std::size_t>(laser));
  const auto& [low, high] = device.description.working_heights_mm;
  VolumeFigures out;
  Mean used, low_mm, low_px, high_mm, high_px, row2, pooled2, px2, saturated, density;
  out.least_depth_mm_per_px = out.dimmest_peak = out.narrowest = 1e9;
  for (int h = 0; h < heights; ++h) {
    const double z = low + (high - low) * h / std::max(1, heights - 1);
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        const Eigen::Vector2d share((c + 0.5) / columns, (r + 0.5) / rows);
        const Eigen::Vector2d xy = device.hand.min() + share.cwiseProduct(device.hand.sizes());
        const Eigen::Vector3d point(xy.x(), xy.y(), z);
        const auto f = FiguresAt(device, source, point);
        const bool fine = f && f->lit && f->seen;
        used.Add(fine ? 1.0 : 0.0);
        density.Add(fine ? 100.0 * RowsPerMm(device.camera, point) / f->spacing_mm : 0.0);
        if (!fine) continue;
        const StripeProfile profile = ProfileAt(device, source, point, *f, surface);
        const CentreNoise noise =
            StripeCentreNoise(profile, device.description.sensor, device.description.speckle);
        const double depth = f->DepthPerPx(), peak = profile.core_peak + profile.wide_peak;
        out.least_depth_mm_per_px = std::min(out.least_depth_mm_per_px, depth);
        out.most_depth_mm_per_px = std::max(out.most_depth_mm_per_px, depth);
        out.dimmest_peak = std::min(out.dimmest_peak, peak);
        out.brightest_peak = std::max(out.brightest_peak, peak);
        out.narrowest = std::min(out.narrowest, f->SpacingPx() / profile.core_sigma_px);
        if (h == 0) low_mm.Add(f->spacing_mm), low_px.Add(f->SpacingPx());
        if (h == heights - 1) high_mm.Add(f->spacing_mm), high_px.Add(f->SpacingPx());
        saturated.Add(noise.saturated > 0.0 ? 1.0 : 0.0);
        if (!std::isfinite(noise.row_px)) continue;
        const double pooled = noise.PooledPx(surface.pooled_rows, device.description.speckle);
        row2.Add(std::pow(noise.row_px * depth, 2));
        pooled2.Add(std::pow(pooled * depth, 2));
        px2.Add(std::pow(noise.row_px, 2));
      }
    }
  }
  const Eigen::Vector2d centre = device.hand.center();
  if (const auto f = FiguresAt(device, source, {centre.x(), centre.y(), 0.5 * (low + high)}))
    out.middle_depth_mm_per_px = f->DepthPerPx();
  if (used.sum == 0.0) out.least_depth_mm_per_px = out.dimmest_peak = out.narrowest = 0.0;
  out.used = used.Value();
  out.spacing_low_mm = low_mm.Value();
  out.spacing_low_px = low_px.Value();
  out.spacing_high_mm = high_mm.Value();
  out.spacing_high_px = high_px.Value();
  out.row_sigma_mm = std::sqrt(row2.Value());
  out.pooled_sigma_mm = std::sqrt(pooled2.Value());
  out.row_sigma_px = std::sqrt(px2.Value());
  out.saturated = saturated.Value();
  out.points_per_cm2 = density.Value();
  return out;
}

}  // namespace dorsum
