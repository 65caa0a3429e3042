// SPDX-License-Identifier: Apache-2.0
#include "simulator/led_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "base/parallel.h"
#include "simulator/gloss.h"

namespace dorsum {
namespace {

constexpr int kShadowRays = 32;        // per LED and point
constexpr int kGrid = 4;               // px between points whose shadows are traced; the rest is interpolated
constexpr float kSmoothShadow = 0.2F;  // largest difference of visibility that interpolation may bridge
constexpr std::size_t kMaxLeds = 8;

using Visibility = std::array<float, kMaxLeds>;  // share of each LED that a point sees

// Points spread evenly over the LED's disc (a sunflower's spiral), which faces the origin.
std::vector<Eigen::Vector3d> DiscPoints(const VirtualLed& led) {
  const Eigen::Vector3d x = led.position.unitOrthogonal();
  const Eigen::Vector3d y = led.position.normalized().cross(x);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kShadowRays; ++i) {
    const double r = led.radius_mm * std::sqrt((i + 0.5) / kShadowRays);
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    points.emplace_back(led.position + r * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return points;
}

class LedShading {
 public:
  LedShading(const VirtualDevice& device, const SceneTracer& tracer, const Eigen::Vector3d& eye)
      : device_(device), tracer_(tracer), eye_(eye) {
    for (const VirtualLed& led : device.leds) points_.push_back(DiscPoints(led));
  }

  Visibility TraceVisibility(const SurfaceSample& sample) const {
    Visibility visible{};
    if (sample.part < 0) return visible;
    const Eigen::Vector3d normal = sample.face_normal.cast<double>();
    for (std::size_t l = 0; l < points_.size(); ++l) {
      int seen = 0;
      for (const Eigen::Vector3d& light : points_[l]) {
        seen += normal.dot(light - sample.position) > 0.0 && !tracer_.Blocked(sample.position, normal, light);
      }
      visible[l] = static_cast<float>(seen) / kShadowRays;
    }
    return visible;
  }

  float Radiance(const SurfaceSample& sample, const Visibility& visible) const {
    if (sample.part < 0) return 0.0F;
    double irradiance = 0.0, highlight = 0.0;
    for (std::size_t l = 0; l < device_.leds.size(); ++l) {
      const VirtualLed& led = device_.leds[l];
      const Eigen::Vector3d way = led.position - sample.position;
      const double d2 = way.squaredNorm();
      const double cosine = sample.normal.cast<double>().dot(way) / std::sqrt(d2);
      const double here = static_cast<double>(visible[l]) * led.intensity * std::max(0.0, cosine) / d2;
      irradiance += here;
      if (sample.gloss > 0.0F && here > 0.0) highlight += here * MeanHighlight(sample, points_[l]);
    }
    return sample.albedo * static_cast<float>(irradiance) + static_cast<float>(highlight);
  }

 private:
  const VirtualDevice& device_;
  double MeanHighlight(const SurfaceSample& sample, const std::vector<Eigen::Vector3d>& disc) const {
    double sum = 0.0;
    for (const Eigen::Vector3d& light : disc) sum += Highlight(sample, light, eye_);
    return sum / static_cast<double>(disc.size());
  }

  const SceneTracer& tracer_;
  Eigen::Vector3d eye_;
  std::vector<std::vector<Eigen::Vector3d>> points_;  // by LED
};

bool SameSurface(const SurfaceSample& a, const SurfaceSample& b) {
  return a.part == b.part && a.normal.dot(b.normal) > 0.94F;
}

// Visibility at every kGrid-th pixel, and a rule for those between.
class ShadowMap {
 public:
  ShadowMap(const LedShading& shading, const View& view, const Context& context)
      : shading_(shading),
        view_(view),
        columns_((view.width - 1) / kGrid + 1),
        map_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((view.height - 1) / kGrid + 1)) {
    ParallelFor(context, 0, (view.height - 1) / kGrid + 1, [&](std::int64_t row) {
      for (int i = 0; i < columns_ && !context.IsCancelled(); ++i) {
        map_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
             static_cast<std::size_t>(i)] =
            shading.TraceVisibility(view.At(i * kGrid, static_cast<int>(row) * kGrid));
      }
    });
  }

  Visibility Of(int u, int v) const {
    const SurfaceSample& sample = view_.At(u, v);
    const int i = u / kGrid, j = v / kGrid;
    if ((i + 1) * kGrid >= view_.width || (j + 1) * kGrid >= view_.height)
      return shading_.TraceVisibility(sample);
    const float x = static_cast<float>(u % kGrid) / kGrid, y = static_cast<float>(v % kGrid) / kGrid;
    if (x == 0.0F && y == 0.0F) return At(i, j);
    for (const int k : {0, 1, 2, 3}) {
      const SurfaceSample& corner = view_.At((i + k % 2) * kGrid, (j + k / 2) * kGrid);
      if (!SameSurface(sample, corner)) return shading_.TraceVisibility(sample);
    }
    Visibility visible{};
    for (std::size_t l = 0; l < kMaxLeds; ++l) {
      const float a = At(i, j)[l], b = At(i + 1, j)[l], c = At(i, j + 1)[l], d = At(i + 1, j + 1)[l];
      const auto [low, high] = std::minmax({a, b, c, d});
      if (high - low > kSmoothShadow) return shading_.TraceVisibility(sample);
      visible[l] = (1.0F - y) * ((1.0F - x) * a + x * b) + y * ((1.0F - x) * c + x * d);
    }
    return visible;
  }

 private:
  const Visibility& At(int i, int j) const {
    return map_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(i)];
  }

  const LedShading& shading_;
  const View& view_;
  int columns_;
  std::vector<Visibility> map_;
};

// Light of a pixel with fine samples. Each takes the visibility of a pixel's centre around it on the same
// surface, where there is one: tracing 16 times as many shadows would cost more than all the rest.
float FinePixelRadiance(const LedShading& shading, const ShadowMap& shadows, const View& view,
                        const View::FinePixel& fine) {
  constexpr std::array<std::array<int, 2>, 5> kAround = {{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  const int u = static_cast<int>(fine.pixel) % view.width, v = static_cast<int>(fine.pixel) / view.width;
  std::array<std::optional<Visibility>, kAround.size()> known;
  const auto of_sample = [&](const SurfaceSample& sample) {
    for (std::size_t i = 0; i < kAround.size(); ++i) {
      const int x = u + kAround[i][0], y = v + kAround[i][1];
      if (x < 0 || y < 0 || x >= view.width || y >= view.height) continue;
      if (!SameSurface(sample, view.At(x, y))) continue;
      if (!known[i]) known[i] = shadows.Of(x, y);
      return *known[i];
    }
    return shading.TraceVisibility(sample);
  };
  float sum = 0.0F;
  for (const SurfaceSample& sample : fine.samples) sum += shading.Radiance(sample, of_sample(sample));
  return sum / View::kFineCount;
}

}  // namespace

cv::Mat LedLight(const VirtualDevice& device, const SceneTracer& tracer, const View& view,
                 const Context& context) {
  const LedShading shading(device, tracer, view.eye);
  const ShadowMap shadows(shading, view, context);
  cv::Mat light(view.height, view.width, CV_32F);
  ParallelFor(context, 0, view.height, [&](std::int64_t row) {
    const int v = static_cast<int>(row);
    auto* out = light.ptr<float>(v);
    for (int u = 0; u < view.width && !context.IsCancelled(); ++u) {
      out[u] = shading.Radiance(view.At(u, v), shadows.Of(u, v));
    }
  });
  auto* pixels = light.ptr<float>();
  ParallelFor(context, 0, static_cast<std::int64_t>(view.fine.size()), [&](std::int64_t i) {
    const View::FinePixel& fine = view.fine[static_cast<std::size_t>(i)];
    pixels[fine.pixel] = FinePixelRadiance(shading, shadows, view, fine);
  });
  return light;
}

cv::Mat AmbientLight(const View& view, double irradiance) {
  cv::Mat light(view.height, view.width, CV_32F);
  auto* pixels = light.ptr<float>();
  const auto level = static_cast<float>(irradiance);
  for (std::size_t i = 0; i < view.centre.size(); ++i) {
    pixels[i] = view.centre[i].part < 0 ? 0.0F : level * view.centre[i].albedo;
  }
  for (const View::FinePixel& fine : view.fine) {
    float sum = 0.0F;
    for (const SurfaceSample& sample : fine.samples) sum += sample.part < 0 ? 0.0F : level * sample.albedo;
    pixels[fine.pixel] = sum / View::kFineCount;
  }
  return light;
}

}  // namespace dorsum
