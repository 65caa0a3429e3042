// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/plane_device_test.h"
#include "surface/outline.h"
#include "surface/plate.h"
#include "surface/surface_point.h"

namespace dorsum {

// Height of a body over the backplane; NaN beside it. One value for each (x, y), seen by a camera from above.
using BodyHeight = std::function<double(double x, double y)>;

inline Context WithThreads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

// Where the ray of a pixel meets the body: the fixed point of z = body(ray at z).
inline Eigen::Vector3d SeeBody(const Camera& camera, const BodyHeight& body, double u, double v) {
  const Ray ray = CastRay(camera, {u, v});
  Eigen::Vector3d p(0.0, 0.0, 10.0);
  for (int i = 0; i < 30 && std::isfinite(p.z()); ++i) {
    p = ray.At((p.z() - ray.origin.z()) / ray.direction.z());
    p.z() = body(p.x(), p.y());
  }
  return p;
}

// TestCamera sees 0.5 mm per pixel.
struct Scene {
  Camera camera = TestCamera();
  cv::Mat1b mask;
  SurfacePoints points;
};

// Stripes of `lasers` lasers in turn every 8 px (4 mm), leaning a little, on every row of the body.
inline Scene ScanBody(const BodyHeight& body, int lasers = 2, float sigma = 0.05F) {
  Scene s;
  s.mask = cv::Mat1b(s.camera.height, s.camera.width, std::uint8_t{0});
  for (int v = 0; v < s.mask.rows; ++v) {
    for (int u = 0; u < s.mask.cols; ++u) {
      if (std::isfinite(SeeBody(s.camera, body, u, v).z())) s.mask(v, u) = 255;
    }
  }
  for (int stripe = 0; stripe < s.mask.cols / 8; ++stripe) {
    for (int v = 0; v < s.mask.rows; ++v) {
      SurfacePoint p;
      p.u = static_cast<float>(3.0 + 8.0 * stripe + 0.02 * v);
      p.v = static_cast<float>(v);
      p.position = SeeBody(s.camera, body, p.u, p.v);
      if (!p.position.allFinite()) continue;
      p.laser = static_cast<std::uint8_t>(stripe % lasers);
      p.order = static_cast<std::int16_t>(stripe / lasers);
      p.segment = stripe / lasers;
      p.sigma = sigma;
      s.points.push_back(p);
    }
  }
  return s;
}

inline std::vector<PlateSample> SamplesOf(const SurfacePoints& points) {
  std::vector<PlateSample> out;
  for (const SurfacePoint& p : points) {
    out.push_back({p.u, p.v, static_cast<float>(p.position.z()), 1.0F / (p.sigma * p.sigma)});
  }
  return out;
}

// A lattice that is active everywhere.
inline PlateLattice FullLattice(int columns, int rows, double step_px, float stiffness) {
  PlateLattice l;
  l.step_px = step_px;
  l.active = cv::Mat1b(rows, columns, std::uint8_t{255});
  l.z = cv::Mat1f(rows, columns, 0.0F);
  l.stiffness = cv::Mat3f(rows, columns, cv::Vec3f::all(stiffness));
  return l;
}

}  // namespace dorsum
