// SPDX-License-Identifier: Apache-2.0
#include "simulator/laser_light.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "simulator/gloss.h"

namespace dorsum {
namespace {

constexpr double kReach = 4.5;  // standard deviations beyond which a stripe is dark

// A stripe's profile across alpha as a sum of two Gaussians that hold the stripe's whole light.
struct Profile {
  double core_sigma = 0.0, core_peak = 1.0;
  double wide_sigma = 0.0, wide_peak = 0.0;

  double At(double offset) const {
    const auto gauss = [offset](double sigma) { return std::exp(-0.5 * offset * offset / (sigma * sigma)); };
    return core_peak * gauss(core_sigma) + (wide_peak > 0.0 ? wide_peak * gauss(wide_sigma) : 0.0);
  }
  double Reach() const { return kReach * std::max(core_sigma, wide_sigma); }
};

Profile ProfileOn(Material material, const VirtualLaser& laser, const SkinDesign& skin, double distance_mm) {
  const double sigma = laser.sigma_alpha;
  if (material != Material::kSkin) return {sigma, 1.0, 0.0, 0.0};
  // Light that wanders x mm under the skin shows up x / r away in direction cosine.
  Profile p;
  p.core_sigma = std::hypot(sigma, skin.line_blur_mm / distance_mm);
  p.wide_sigma = std::hypot(sigma, skin.scatter_sigma_mm / distance_mm);
  p.core_peak = (1.0 - skin.scatter_share) * sigma / p.core_sigma;
  p.wide_peak = skin.scatter_share * sigma / p.wide_sigma;
  return p;
}

// Whether a stripe may be within reach, without Locate()'s iteration: the exit point is taken for a fan
// without tilt, where y_g = s * dy / sqrt(x^2 + z^2). A tilt moves it by less than 1 mm, and alpha by alpha *
// beta / r.
bool MayBeLit(const VirtualLaser& laser, const Eigen::Vector3d& point, double reach) {
  const DiffractedFan& fan = laser.fan;
  const Eigen::Vector3d d = point - fan.origin;
  const double x = fan.a.dot(d), y = fan.b.dot(d), z = fan.n.dot(d);
  if (z <= 0.0) return false;
  const double q = std::sqrt(x * x + z * z);
  const double dy = y * q / (q + fan.fan_distance_mm);
  const double r = std::sqrt(x * x + dy * dy + z * z);
  const double alpha = x / r, beta = dy / r;
  const double order = (alpha - IncomingAlpha(fan, beta)) / fan.step;
  const double nearest = std::clamp(std::round(order), -1.0 * laser.Orders(), 1.0 * laser.Orders());
  return std::abs(order - nearest) * fan.step < reach + std::abs(alpha * beta) / r + 1e-4;
}

double Radiance(const VirtualLaser& laser, const SkinDesign& skin, const SceneTracer& tracer,
                const Eigen::Vector3d& eye, const SurfaceSample& sample) {
  if (sample.part < 0) return 0.0;
  const double rough_distance = (sample.position - laser.fan.origin).norm();
  const Profile profile = ProfileOn(sample.material, laser, skin, rough_distance);
  if (!MayBeLit(laser, sample.position, profile.Reach())) return 0.0;
  const auto at = Locate(laser.fan, sample.position);
  if (!at) return 0.0;
  const Eigen::Vector3d normal = sample.normal.cast<double>();
  const double order = at->Order(laser.fan);
  const double reach = profile.Reach() / laser.fan.step;
  const Profile mirrored{laser.sigma_alpha, 1.0, 0.0, 0.0};  // what never went under the skin
  double light = 0.0, highlight = 0.0;
  const int first = std::max(-laser.Orders(), static_cast<int>(std::ceil(order - reach)));
  const int last = std::min(laser.Orders(), static_cast<int>(std::floor(order + reach)));
  for (int m = first; m <= last; ++m) {
    const double peak = PeakIrradiance(laser, m, *at, sample.position, normal);
    const double offset = (order - m) * laser.fan.step;
    light += peak * profile.At(offset);
    if (sample.gloss > 0.0F) highlight += peak * mirrored.At(offset);
  }
  if (light < 1e-6) return 0.0;
  if (!IsLit(tracer, *at, sample.position, sample.face_normal.cast<double>())) return 0.0;
  return light * static_cast<double>(sample.albedo) + highlight * Highlight(sample, at->exit, eye);
}

}  // namespace

double FanWindow(const VirtualLaser& laser, const FanCoordinates& at) {
  // The fan's own angle is measured in its plane: sin(angle) = beta / sqrt(1 - alpha_in^2).
  const double angle = std::asin(std::clamp(at.beta / std::sqrt(1.0 - at.alpha_in * at.alpha_in), -1.0, 1.0));
  const double soft = 0.04 * laser.half_angle;
  const double t = std::clamp((laser.half_angle - std::abs(angle)) / soft, 0.0, 1.0);
  double window = t * t * (3.0 - 2.0 * t);
  for (const DirtySpot& spot : laser.dirt) {
    const double distance = (at.beta - spot.beta) / spot.half_width;
    window *= 1.0 - (1.0 - spot.transmission) / (1.0 + std::pow(distance, 8.0));
  }
  return window;
}

double PeakIrradiance(const VirtualLaser& laser, int order, const FanCoordinates& at,
                      const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const double cosine = normal.dot(at.exit - point) / at.distance_mm;
  if (cosine <= 0.0) return 0.0;
  const double gamma = std::sqrt(std::max(0.0, 1.0 - at.alpha * at.alpha - at.beta * at.beta));
  return laser.power * laser.Efficiency(order) * FanWindow(laser, at) * gamma * cosine /
         (at.distance_mm * (at.distance_mm + laser.fan.fan_distance_mm));
}

bool IsLit(const SceneTracer& tracer, const FanCoordinates& at, const Eigen::Vector3d& point,
           const Eigen::Vector3d& face_normal) {
  return face_normal.dot(at.exit - point) > 0.0 && !tracer.Blocked(point, face_normal, at.exit);
}

cv::Mat LaserLight(const VirtualLaser& laser, const SkinDesign& skin, const SceneTracer& tracer,
                   const View& view, const Context& context) {
  cv::Mat light(view.height, view.width, CV_32F);
  ParallelFor(context, 0, view.height, [&](std::int64_t row) {
    auto* out = light.ptr<float>(static_cast<int>(row));
    for (int u = 0; u < view.width && !context.IsCancelled(); ++u) {
      out[u] = static_cast<float>(Radiance(laser, skin, tracer, view.eye, view.At(u, static_cast<int>(row))));
    }
  });
  auto* pixels = light.ptr<float>();
  ParallelFor(context, 0, static_cast<std::int64_t>(view.fine.size()), [&](std::int64_t i) {
    const View::FinePixel& fine = view.fine[static_cast<std::size_t>(i)];
    double sum = 0.0;
    for (const SurfaceSample& sample : fine.samples) sum += Radiance(laser, skin, tracer, view.eye, sample);
    pixels[fine.pixel] = static_cast<float>(sum / View::kFineCount);
  });
  return light;
}

}  // namespace dorsum
