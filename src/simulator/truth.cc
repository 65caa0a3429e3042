// SPDX-License-Identifier: Apache-2.0
#include "simulator/truth.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "simulator/laser_light.h"
#include "simulator/truth_files.h"

namespace dorsum {
namespace {

constexpr double kDarkest = 0.005;  // irradiance below which a stripe counts as not there

// The order as a real number along one image row.
class RowOrder {
 public:
  RowOrder(const VirtualDevice& device, const SceneTracer& tracer, const VirtualLaser& laser, int row)
      : device_(device), tracer_(tracer), laser_(laser), row_(row) {}

  struct Point {
    SurfaceHit hit;
    FanCoordinates at;
    double order = 0.0;
  };

  std::optional<Point> At(double u) const {
    const auto hit = tracer_.Trace(CastRay(device_.camera, {u, static_cast<double>(row_)}));
    if (!hit) return std::nullopt;
    const auto at = Locate(laser_.fan, hit->position);
    if (!at) return std::nullopt;
    return Point{*hit, *at, at->Order(laser_.fan)};
  }

  // The point between two columns whose order is m: regula falsi (Illinois), halved where that is slow. None
  // where the surface jumps over it.
  std::optional<std::pair<double, Point>> Solve(double m, double u0, double f0, double u1, double f1) const {
    std::optional<Point> best;
    double u = u0;
    for (int i = 0; i < 60; ++i) {
      u = i % 4 == 3 ? 0.5 * (u0 + u1) : u0 - f0 * (u1 - u0) / (f1 - f0);
      best = At(u);
      if (!best) return std::nullopt;
      const double f = best->order - m;
      if (std::abs(f) < 1e-10 || u1 - u0 < 1e-9) break;
      if ((f < 0.0) == (f0 < 0.0)) {
        u0 = u;
        f0 = f;
        f1 *= 0.5;
      } else {
        u1 = u;
        f1 = f;
        f0 *= 0.5;
      }
    }
    if (std::abs(best->order - m) * laser_.fan.step > 1e-8) return std::nullopt;
    return std::pair{u, *best};
  }

 private:
  const VirtualDevice& device_;
  const SceneTracer& tracer_;
  const VirtualLaser& laser_;
  int row_;
};

// The order to about 0.01, without Locate()'s iteration: enough to see where a whole number may be crossed.
double RoughOrder(const DiffractedFan& fan, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d = point - fan.origin;
  const double x = fan.a.dot(d), y = fan.b.dot(d), z = fan.n.dot(d);
  const double q = std::sqrt(x * x + z * z);
  const double dy = y * q / (q + fan.fan_distance_mm);
  const double r = std::sqrt(q * q + dy * dy);
  return (x / r - IncomingAlpha(fan, dy / r)) / fan.step;
}

// Whether the surface jumps or bends sharply between two neighbouring pixels.
bool IsEdge(const SurfaceSample& a, const SurfaceSample& b) {
  constexpr double kJumpMm = 2.0;
  constexpr float kLeastCosine = 0.8F;
  return a.part != b.part || (a.position - b.position).squaredNorm() > kJumpMm * kJumpMm ||
         a.face_normal.dot(b.face_normal) < kLeastCosine;
}

std::vector<TrueStripePoint> StripesOfRow(const VirtualDevice& device, const Stage& stage,
                                          const VirtualLaser& laser, int row) {
  constexpr double kSlack = 0.02;
  constexpr int kPiecesAtEdge = 16;
  const RowOrder along(device, stage.tracer, laser, row);
  const double last_order = laser.Orders();
  std::vector<TrueStripePoint> points;
  // Where the order is m between two columns.
  const auto add = [&](double m, double u0, double f0, double u1, double f1) {
    // A stripe exactly on a pixel's centre belongs to the pair on its left only.
    if ((f0 < 0.0) == (f1 < 0.0)) return;
    const auto solution = along.Solve(m, u0, f0, u1, f1);
    if (!solution) return;
    const auto& [column, point] = *solution;
    const int order = static_cast<int>(m);
    const double irradiance = PeakIrradiance(laser, order, point.at, point.hit.position, point.hit.normal);
    if (irradiance < kDarkest || !IsLit(stage.tracer, point.at, point.hit.position, point.hit.face_normal))
      return;
    const Material material = stage.tracer.PaintAt(point.hit, 1e-3).material;
    points.push_back({order, row, column, point.hit.position.z(), material, irradiance});
  };
  double left_rough = 0.0;
  for (int u = 0; u < stage.view.width; ++u) {
    const SurfaceSample& sample = stage.view.At(u, row);
    const double rough = sample.part < 0 ? NAN : RoughOrder(laser.fan, sample.position);
    const double left = std::exchange(left_rough, rough);
    if (u == 0 || std::isnan(left) || std::isnan(rough)) continue;
    const double low = std::min(left, rough) - kSlack, high = std::max(left, rough) + kSlack;
    const double first = std::max(-last_order, std::ceil(low)), last = std::min(last_order, std::floor(high));
    // An edge between the two has stripes end on either side of it, also such as neither centre tells of.
    const bool at_edge = IsEdge(stage.view.At(u - 1, row), sample);
    if (first > last && !at_edge) continue;
    const int pieces = at_edge ? kPiecesAtEdge : 1;
    auto a = along.At(u - 1);
    for (int piece = 1; piece <= pieces; ++piece) {
      const double u0 = u - 1 + (piece - 1.0) / pieces, u1 = u - 1 + static_cast<double>(piece) / pieces;
      const auto before = std::exchange(a, along.At(u1));
      if (!before || !a) continue;
      const double to = at_edge ? last_order : last;
      for (double m = at_edge ? -last_order : first; m <= to; m += 1.0) {
        add(m, u0, before->order - m, u1, a->order - m);
      }
    }
  }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.u < b.u; });
  return points;
}

}  // namespace

Result<std::vector<TrueStripePoint>> TrueStripes(const VirtualDevice& device, const Stage& stage, int laser,
                                                 const Context& context) {
  const VirtualLaser& source = device.lasers.at(static_cast<std::size_t>(laser));
  std::vector<std::vector<TrueStripePoint>> rows(static_cast<std::size_t>(stage.view.height));
  ParallelFor(context, 0, stage.view.height, [&](std::int64_t row) {
    if (context.IsCancelled()) return;
    rows[static_cast<std::size_t>(row)] = StripesOfRow(device, stage, source, static_cast<int>(row));
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  std::vector<TrueStripePoint> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

Status WriteSurfaceTruth(const Stage& stage, const std::filesystem::path& dir) {
  DORSUM_RETURN_IF_ERROR(WriteHeights(stage.view, dir / "height.png"));
  DORSUM_RETURN_IF_ERROR(WriteMaterials(stage.view, dir / "material.png"));
  return WriteReferencePly(ObjectMesh(stage.tracer.scene()), dir / "reference.ply");
}

Status WriteStripeTruth(const VirtualDevice& device, const Stage& stage, int laser,
                        const std::filesystem::path& dir, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const auto points, TrueStripes(device, stage, laser, context));
  return WriteStripes(points, dir / ("stripes" + std::to_string(laser) + ".csv.gz"));
}

}  // namespace dorsum
