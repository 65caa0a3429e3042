// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <Eigen/Core>

#include "geometry/mesh.h"

namespace dorsum {

using SignedDistance = std::function<double(const Eigen::Vector3d&)>;  // mm, negative inside

struct SurfaceNetsOptions {
  Eigen::Vector3d lo = Eigen::Vector3d::Zero(),
                  hi = Eigen::Vector3d::Zero();  // a box that holds the surface, mm
  double cell = 0.7;                             // mm; about the edge length of the mesh
  double steepness =
      1.6;               // upper bound of |distance| growth per mm: what may be skipped far from the surface
  int newton_steps = 2;  // of each vertex along the gradient onto the surface
};

// Gradient by differences over a small tetrahedron.
Eigen::Vector3d Gradient(const SignedDistance& distance, const Eigen::Vector3d& point, double step = 0.03);

// The zero set as a closed mesh with normals along the gradient: one vertex for each sheet of surface in a
// cell, one quad across each grid edge that it crosses (Gibson 1998), then Newton steps onto the surface.
TriangleMesh SurfaceNets(const SignedDistance& distance, const SurfaceNetsOptions& options);

}  // namespace dorsum
