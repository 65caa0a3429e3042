// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "geometry/ray.h"
#include "simulator/scene.h"

namespace dorsum {

struct SurfaceHit {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d face_normal = Eigen::Vector3d::UnitZ();  // of the facet, towards where the ray came from
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();       // for shading: smooth where the part is
  double distance_mm = 0.0;
  int part = 0;  // index into Scene::parts
  std::array<std::uint32_t, 3> face{};
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // of the face's three vertices
};

// Rays against the triangles of a scene. Embree finds the facet in single precision; the point on it is then
// computed in double, so that it lies exactly on the facet's plane. Safe to use from many threads.
class SceneTracer {
 public:
  explicit SceneTracer(Scene scene);
  ~SceneTracer();
  SceneTracer(SceneTracer&&) noexcept;
  SceneTracer& operator=(SceneTracer&&) noexcept;

  const Scene& scene() const { return scene_; }
  std::optional<SurfaceHit> Trace(const Ray& ray) const;
  // Whether something lies between a surface point and a light; `face_normal` is the surface's.
  bool Blocked(const Eigen::Vector3d& point, const Eigen::Vector3d& face_normal,
               const Eigen::Vector3d& light) const;
  Paint PaintAt(const SurfaceHit& hit, double footprint_mm) const;

 private:
  struct Embree;
  Scene scene_;
  std::unique_ptr<Embree> embree_;
};

}  // namespace dorsum
