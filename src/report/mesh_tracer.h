// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <Eigen/Core>

#include "geometry/mesh.h"
#include "geometry/ray.h"

namespace dorsum {

struct MeshHit {
  std::uint32_t face = 0;
  double distance_mm = 0.0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // of the face's three vertices, sum 1
};

// Rays against a mesh, by Embree. Keeps its own copy of the triangles; those with a vertex that is not finite
// are never hit. Safe to use from many threads.
class MeshTracer {
 public:
  explicit MeshTracer(const TriangleMesh& mesh);
  ~MeshTracer();
  MeshTracer(MeshTracer&&) noexcept;
  MeshTracer& operator=(MeshTracer&&) noexcept;

  std::optional<MeshHit> Trace(const Ray& ray) const;
  // Whether a ray meets the mesh between the two distances.
  bool IsBlocked(const Ray& ray, double near_mm, double far_mm) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace dorsum
