// SPDX-License-Identifier: Apache-2.0
#include "geometry/calibration.h"

#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

double OrderFromPlanes(const std::vector<PlaneSheet>& planes, const Eigen::Vector3d& p) {
  // The two sheets around the point, or the outermost two.
  std::size_t right = 1;
  while (right + 1 < planes.size() && planes[right].plane.SignedDistance(p) > 0.0) ++right;
  const double to_left = planes[right - 1].plane.SignedDistance(p);
  const double to_right = planes[right].plane.SignedDistance(p);
  return planes[right - 1].order + to_left / (to_left - to_right);
}

// Secants on the order along the ray, which is nearly linear, from a height of `start_mm`.
std::optional<Eigen::Vector3d> IntersectCone(const Ray& ray, const DiffractedFan& fan, int order,
                                             double start_mm) {
  constexpr double kStep = 1e-2;  // mm
  const double start = (ray.origin.z() - start_mm) / std::max(1e-9, -ray.direction.z());
  const auto first = Locate(fan, ray.At(start - kStep));
  if (!first) return std::nullopt;
  double t = start, last_t = start - kStep, last_value = first->Order(fan) - order;
  for (int i = 0; i < 30; ++i) {
    const auto here = Locate(fan, ray.At(t));
    if (!here) return std::nullopt;
    const double value = here->Order(fan) - order, slope = (value - last_value) / (t - last_t);
    if (!(std::abs(slope) > 1e-12)) return std::nullopt;
    const double change = value / slope;
    last_t = t;
    last_value = value;
    t -= change;
    if (t < 0.0) return std::nullopt;
    if (std::abs(change) < 1e-6) return ray.At(t);  // the next change would be below 1e-12
  }
  return std::nullopt;
}

}  // namespace

double ReferenceStripe::ColumnAt(double v) const {
  const double t = (v - middle_v) / half_v;
  return u[0] + t * (u[1] + t * (u[2] + t * u[3]));
}

double ReferenceStripe::PeakAt(double v) const {
  const double t = (v - middle_v) / half_v;
  return peak[0] + t * (peak[1] + t * peak[2]);
}

const PlaneSheet* LaserGeometry::FindPlane(int order) const {
  const auto it =
      std::find_if(planes.begin(), planes.end(), [&](const PlaneSheet& s) { return s.order == order; });
  return it == planes.end() ? nullptr : &*it;
}

const LaserGeometry* DeviceGeometry::FindLaser(int laser) const {
  const auto it =
      std::find_if(lasers.begin(), lasers.end(), [&](const LaserGeometry& l) { return l.laser == laser; });
  return it == lasers.end() ? nullptr : &*it;
}

std::optional<double> OrderAtHeight(const Camera& camera, const LaserGeometry& laser, SheetModel model,
                                    const Eigen::Vector2d& pixel, double z_mm) {
  return OrderAtHeight(CastRay(camera, pixel), laser, model, z_mm);
}

std::optional<double> OrderAtHeight(const Ray& ray, const LaserGeometry& laser, SheetModel model,
                                    double z_mm) {
  const auto t = Intersect(ray, Plane{Eigen::Vector3d::UnitZ(), z_mm});
  if (!t) return std::nullopt;
  const Eigen::Vector3d p = ray.At(*t);
  if (model == SheetModel::kPlane) {
    if (laser.planes.size() < 2) return std::nullopt;
    return OrderFromPlanes(laser.planes, p);
  }
  if (!laser.fan) return std::nullopt;
  const auto located = Locate(*laser.fan, p);
  if (!located) return std::nullopt;
  return located->Order(*laser.fan);
}

std::optional<Eigen::Vector3d> IntersectSheet(const Ray& ray, const LaserGeometry& laser, SheetModel model,
                                              int order, double start_mm) {
  if (model == SheetModel::kCone) {
    if (!laser.fan) return std::nullopt;
    return IntersectCone(ray, *laser.fan, order, start_mm);
  }
  const PlaneSheet* sheet = laser.FindPlane(order);
  if (sheet == nullptr) return std::nullopt;
  const auto t = Intersect(ray, sheet->plane);
  if (!t) return std::nullopt;
  return ray.At(*t);
}

}  // namespace dorsum
