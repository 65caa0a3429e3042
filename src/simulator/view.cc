// SPDX-License-Identifier: Apache-2.0
#include "simulator/view.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace dorsum {
namespace {

// Neighbours on one smooth piece of surface need no finer samples: same part, similar normal, and each close
// to the other's tangent plane.
bool Continues(const SurfaceSample& a, const SurfaceSample& b) {
  if (a.part != b.part) return false;
  if (a.part < 0) return true;
  if (a.face_normal.dot(b.face_normal) < 0.9F) return false;
  const Eigen::Vector3f d = (b.position - a.position).cast<float>();
  return std::abs(a.face_normal.dot(d)) < 0.3F + 0.3F * d.norm();
}

bool NeedsFineSamples(const View& view, int column, int row) {
  const SurfaceSample& here = view.At(column, row);
  return (column > 0 && !Continues(here, view.At(column - 1, row))) ||
         (column + 1 < view.width && !Continues(here, view.At(column + 1, row))) ||
         (row > 0 && !Continues(here, view.At(column, row - 1))) ||
         (row + 1 < view.height && !Continues(here, view.At(column, row + 1)));
}

}  // namespace

SurfaceSample SampleAt(const Camera& camera, const SceneTracer& tracer, const Eigen::Vector2d& pixel,
                       double share) {
  const Ray ray = CastRay(camera, pixel);
  SurfaceSample sample;
  const auto hit = tracer.Trace(ray);
  if (!hit) return sample;
  // A pixel sees (distance / focal)^2 across its ray, and that over the cosine on the surface.
  const double cosine = std::max(0.05, -hit->face_normal.dot(ray.direction));
  const double footprint_mm = share * hit->distance_mm / (camera.fx * std::sqrt(cosine));
  const Paint paint = tracer.PaintAt(*hit, footprint_mm);
  sample.position = hit->position;
  sample.normal = hit->normal.cast<float>();
  sample.face_normal = hit->face_normal.cast<float>();
  sample.albedo = static_cast<float>(paint.albedo);
  sample.gloss = static_cast<float>(paint.gloss);
  sample.shininess = static_cast<float>(tracer.scene().parts[static_cast<std::size_t>(hit->part)].shininess);
  sample.part = static_cast<std::int16_t>(hit->part);
  sample.material = paint.material;
  return sample;
}

Result<View> TraceView(const Camera& camera, const SceneTracer& tracer, const Context& context) {
  View view;
  view.width = camera.width;
  view.height = camera.height;
  view.eye = camera.Center();
  const auto columns = static_cast<std::size_t>(camera.width), rows = static_cast<std::size_t>(camera.height);
  view.centre.resize(columns * rows);
  ParallelFor(context, 0, camera.height, [&](std::int64_t row) {
    if (context.IsCancelled()) return;
    for (int u = 0; u < camera.width; ++u) {
      view.centre[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(u)] =
          SampleAt(camera, tracer, {u, static_cast<double>(row)}, 1.0);
    }
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());

  for (int row = 0; row < view.height; ++row) {
    for (int u = 0; u < view.width; ++u) {
      if (NeedsFineSamples(view, u, row)) {
        view.fine.emplace_back().pixel = static_cast<std::uint32_t>(row * view.width + u);
      }
    }
  }
  ParallelFor(context, 0, static_cast<std::int64_t>(view.fine.size()), [&](std::int64_t i) {
    if (context.IsCancelled()) return;
    View::FinePixel& fine = view.fine[static_cast<std::size_t>(i)];
    const auto u = fine.pixel % columns, v = fine.pixel / columns;
    for (int s = 0; s < View::kFineCount; ++s) {
      const int column = s % View::kFineSide, row = s / View::kFineSide;
      const double du = (column + 0.5) / View::kFineSide - 0.5;
      const double dv = (row + 0.5) / View::kFineSide - 0.5;
      fine.samples[static_cast<std::size_t>(s)] =
          SampleAt(camera, tracer, {u + du, v + dv}, 1.0 / View::kFineSide);
    }
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return view;
}

}  // namespace dorsum
