// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "studio/point_grid.h"
#include "surface/mesh_height.h"

namespace dorsum {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr double kCarry_mm =
    6.0;  // half of the widest gap between stripes that a mesh bridges (HeightFieldOptions)
constexpr double kMean_mm = 1.0;
const Colour kPlain(196, 200, 204);

float Difference(const Eigen::Vector3d& p, const OtherHeight& other) {
  if (!other) return kNone;
  const std::optional<double> z = other(p.x(), p.y());
  return z ? static_cast<float>(p.z() - *z) : kNone;
}

float ValueOf(const SurfacePoint& p, ColourBy by) {
  if (by == ColourBy::kOrder) return static_cast<float>(p.order);
  if (by == ColourBy::kLaser) return static_cast<float>(p.laser);
  return p.sigma;
}

bool IsClasses(ColourBy by) { return by == ColourBy::kOrder || by == ColourBy::kLaser; }

// Of the finite values; the share is in [0, 1].
double Quantile(std::vector<float>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1.0));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Colour ColourScale::At(double value) const {
  if (by == ColourBy::kShaded || !std::isfinite(value)) return kPlain;
  if (IsClasses(by)) {
    const auto found = classes.find(static_cast<int>(value));
    return found == classes.end() ? kPlain : found->second;
  }
  if (by == ColourBy::kDifference) return DivergingColour(value / high);
  return SequentialColour((value - low) / (high - low));
}

OtherHeight MakeOtherHeight(const Reconstruction& surface) {
  if (!surface.mesh.faces.empty()) {
    const auto mesh = std::make_shared<const TriangleMesh>(surface.mesh);
    const auto height = std::make_shared<const MeshHeight>(*mesh);
    return [mesh, height](double x, double y) { return height->At(x, y); };
  }
  const auto points = std::make_shared<const SurfacePoints>(surface.points);
  const auto grid = std::make_shared<const PointGrid>(*points, kMean_mm);
  return [points, grid](double x, double y) -> std::optional<double> {
    double sum = 0.0;
    int count = 0;
    grid->ForNear(x, y, [&](std::uint32_t i) {
      const Eigen::Vector3d& p = (*points)[i].position;
      if (std::hypot(p.x() - x, p.y() - y) > kMean_mm) return;
      sum += p.z();
      ++count;
    });
    if (count == 0) return std::nullopt;
    return sum / count;
  };
}

std::vector<float> PointValues(const SurfacePoints& points, ColourBy by, const OtherHeight& other) {
  std::vector<float> values(points.size(), kNone);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    if (by == ColourBy::kHeight) values[i] = static_cast<float>(p.position.z());
    if (by == ColourBy::kDifference) values[i] = Difference(p.position, other);
    if (by == ColourBy::kUncertainty || IsClasses(by)) values[i] = ValueOf(p, by);
  }
  return values;
}

std::vector<float> VertexValues(const Reconstruction& surface, ColourBy by, const OtherHeight& other) {
  const std::vector<Eigen::Vector3d>& vertices = surface.mesh.vertices;
  std::vector<float> values(vertices.size(), kNone);
  if (by == ColourBy::kHeight || by == ColourBy::kDifference) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      values[i] =
          by == ColourBy::kHeight ? static_cast<float>(vertices[i].z()) : Difference(vertices[i], other);
    }
  } else if (by != ColourBy::kShaded) {
    const PointGrid grid(surface.points, kCarry_mm);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::optional<std::uint32_t> nearest = grid.Nearest(vertices[i]);
      if (nearest) values[i] = ValueOf(surface.points[*nearest], by);
    }
  }
  return values;
}

ColourScale MakeScale(ColourBy by, const std::vector<float>& points, const std::vector<float>& vertices) {
  ColourScale scale;
  scale.by = by;
  std::vector<float> all;
  for (const std::vector<float>* some : {&points, &vertices}) {
    for (const float v : *some) {
      if (std::isfinite(v)) all.push_back(v);
    }
  }
  if (IsClasses(by)) {
    for (const float v : all) {
      const int number = static_cast<int>(v);
      // Lasers have no central one, so none of them is white.
      scale.classes.try_emplace(number, OrderColour(by == ColourBy::kLaser ? number + 1 : number));
    }
    return scale;
  }
  if (all.empty()) return scale;
  if (by == ColourBy::kHeight) {
    const auto [low, high] = std::minmax_element(all.begin(), all.end());
    scale.low = *low;
    scale.high = *high;
  } else {
    for (float& v : all) v = std::abs(v);
    scale.high = Quantile(all, 0.98);
    scale.low = by == ColourBy::kDifference ? -scale.high : 0.0;
  }
  if (!(scale.high - scale.low > 1e-6)) {
    scale.high += 1e-3;
    scale.low -= by == ColourBy::kUncertainty ? 0.0 : 1e-3;
  }
  return scale;
}

DifferenceSummary Summarize(const std::vector<float>& differences) {
  DifferenceSummary summary;
  for (const float d : differences) {
    if (!std::isfinite(d)) {
      ++summary.outside;
      continue;
    }
    ++summary.compared;
    summary.mean_mm += d;
    summary.rms_mm += static_cast<double>(d) * d;
  }
  if (summary.compared > 0) {
    summary.mean_mm /= static_cast<double>(summary.compared);
    summary.rms_mm = std::sqrt(summary.rms_mm / static_cast<double>(summary.compared));
  }
  return summary;
}

}  // namespace dorsum
