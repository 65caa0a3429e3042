// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_point.h"

#include <algorithm>

namespace dorsum {
namespace {

constexpr double kStepMm = 1e-2;  // of central differences; orders are smooth over tens of mm

std::optional<double> OrderAt(const DesignedLaser& laser, const Eigen::Vector3d& point) {
  const auto at = Locate(laser.fan, point);
  if (!at) return std::nullopt;
  return at->Order(laser.fan);
}

std::optional<Eigen::Vector3d> OrderGradient(const DesignedLaser& laser, const Eigen::Vector3d& point) {
  Eigen::Vector3d gradient;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStepMm * Eigen::Vector3d::Unit(i);
    const auto ahead = OrderAt(laser, point + step), behind = OrderAt(laser, point - step);
    if (!ahead || !behind) return std::nullopt;
    gradient[i] = (*ahead - *behind) / (2.0 * kStepMm);
  }
  return gradient;
}

// Where the pixel's ray meets the level through `z`; the caller knows that it does.
Eigen::Vector3d AtHeight(const Ray& ray, double z) {
  return ray.At((z - ray.origin.z()) / ray.direction.z());
}

double TanSquared(const Camera& camera, const Eigen::Vector2d& pixel) {
  const double x = (pixel.x() - camera.cx) / camera.fx, y = (pixel.y() - camera.cy) / camera.fy;
  return x * x + y * y;
}

// Share of light that lens (cosine to the fourth) and filter leave at a pixel.
double ThroughLensShare(const DesignedDevice& device, const Eigen::Vector2d& pixel) {
  const Camera& camera = device.camera;
  const double t = TanSquared(camera, pixel), corner = TanSquared(camera, {0.0, 0.0});
  const double cosine_squared = 1.0 / (1.0 + t);
  const double filter = 1.0 - device.description.sensor.filter_falloff * std::min(1.0, t / corner);
  return cosine_squared * cosine_squared * filter;
}

}  // namespace

std::optional<double> OrderAlongRay(const Ray& ray, const DesignedLaser& laser, double z) {
  if (!(ray.direction.z() < 0.0)) return std::nullopt;
  return OrderAt(laser, AtHeight(ray, z));
}

std::optional<PointFigures> FiguresAt(const DesignedDevice& device, const DesignedLaser& laser,
                                      const Eigen::Vector3d& point) {
  const auto at = Locate(laser.fan, point);
  const auto gradient = OrderGradient(laser, point);
  if (!at || !gradient) return std::nullopt;
  const Camera& camera = device.camera;
  PointFigures f;
  f.order = at->Order(laser.fan);
  f.beta = at->beta;
  const double across = std::sqrt(1.0 - at->alpha_in * at->alpha_in);
  const bool in_fan = std::abs(std::asin(std::clamp(at->beta / across, -1.0, 1.0))) <= laser.half_angle;
  f.lit = in_fan && std::abs(f.order) <= laser.Orders() + 0.5;
  f.pixel = Project(camera, point);
  f.seen = f.pixel.x() >= 0.0 && f.pixel.y() >= 0.0 && f.pixel.x() <= camera.width - 1.0 &&
           f.pixel.y() <= camera.height - 1.0;
  constexpr double kHalfPx = 0.25;
  const Ray left = CastRay(camera, f.pixel - Eigen::Vector2d(kHalfPx, 0.0));
  const Ray right = CastRay(camera, f.pixel + Eigen::Vector2d(kHalfPx, 0.0));
  if (!(left.direction.z() < 0.0 && right.direction.z() < 0.0)) return std::nullopt;
  const Eigen::Vector3d along_row =
      (AtHeight(right, point.z()) - AtHeight(left, point.z())) / (2.0 * kHalfPx);
  const Eigen::Vector3d towards = point - camera.Center();
  f.order_per_px = gradient->dot(along_row);
  f.order_per_mm = gradient->dot(towards) / towards.z();
  f.spacing_mm = 1.0 / gradient->head<2>().norm();
  return f;
}

StripeProfile ProfileAt(const DesignedDevice& device, const DesignedLaser& laser,
                        const Eigen::Vector3d& point, const PointFigures& figures,
                        const SurfaceAssumption& surface) {
  const DeviceDescription& d = device.description;
  const auto at = Locate(laser.fan, point);
  const auto order =
      static_cast<std::size_t>(std::min<long>(std::labs(std::lround(figures.order)), laser.Orders()));
  const double gamma = std::sqrt(std::max(0.0, 1.0 - at->alpha * at->alpha - at->beta * at->beta));
  const double cosine = (at->exit.z() - point.z()) / at->distance_mm;
  const double lens = ThroughLensShare(device, figures.pixel);
  const double light = surface.albedo * lens * laser.power * laser.efficiency[order] * gamma * cosine /
                       (at->distance_mm * (at->distance_mm + laser.fan.fan_distance_mm));
  // A change of direction cosine by one step is one spacing in the picture. What wanders x mm under the skin
  // shows up x / r away in direction cosine; the lens blurs what is left, and light lost from the peak is in
  // the width.
  const double px_per_alpha = figures.SpacingPx() / laser.fan.step;
  const double psf = d.sensor.psf_sigma_px;
  const auto width_px = [&](double blur_mm) {
    return std::hypot(px_per_alpha * std::hypot(laser.sigma_alpha, blur_mm / at->distance_mm), psf);
  };
  const double line_px = px_per_alpha * laser.sigma_alpha;
  StripeProfile profile;
  profile.core_sigma_px = width_px(surface.skin ? d.skin.line_blur_mm : 0.0);
  profile.core_peak =
      (surface.skin ? 1.0 - d.skin.scatter_share : 1.0) * light * line_px / profile.core_sigma_px;
  profile.wide_sigma_px = width_px(d.skin.scatter_sigma_mm);
  profile.wide_peak = surface.skin ? d.skin.scatter_share * light * line_px / profile.wide_sigma_px : 0.0;
  profile.background = d.light.ambient_laser * surface.albedo * lens;
  return profile;
}

}  // namespace dorsum
