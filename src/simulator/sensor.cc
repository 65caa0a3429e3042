// SPDX-License-Identifier: Apache-2.0
#include "simulator/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "base/random.h"

namespace dorsum {
namespace {

// Nearly normal, mean 0 and deviation 1, of 64 random bits: the sum of four uniform draws (Irwin-Hall), which
// needs no library functions whose last bit differs between machines.
float NormalFromBits(std::uint64_t bits) {
  const auto part = [bits](int shift) { return static_cast<float>(bits >> shift & 0xffffU); };
  constexpr float kMean = 2.0F * 65535.0F;
  constexpr float kDeviation = 65535.0F * 0.57735027F;  // sqrt(4 / 12)
  return (part(0) + part(16) + part(32) + part(48) - kMean) / kDeviation;
}

float PixelNoise(std::uint64_t seed, std::uint64_t pixel) {
  return NormalFromBits(MixBits(seed + 0x9e3779b97f4a7c15ULL * (pixel + 1)));
}

std::vector<float> GaussKernel(double sigma) {
  const int radius = static_cast<int>(std::ceil(4.0 * sigma));
  std::vector<float> kernel;
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum));
  }
  return kernel;
}

// Separable Gaussian blur; beyond the border lies the border's value.
cv::Mat Blur(const cv::Mat& in, double sigma, const Context& context) {
  if (sigma < 0.05) return in.clone();
  const std::vector<float> kernel = GaussKernel(sigma);
  const int radius = static_cast<int>(kernel.size()) / 2;
  cv::Mat across(in.size(), CV_32F), out(in.size(), CV_32F);
  ParallelFor(context, 0, in.rows, [&](std::int64_t row) {
    std::vector<float> padded(static_cast<std::size_t>(in.cols + 2 * radius));
    const auto* from = in.ptr<float>(static_cast<int>(row));
    for (int i = -radius; i < in.cols + radius; ++i) {
      padded[static_cast<std::size_t>(i + radius)] = from[std::clamp(i, 0, in.cols - 1)];
    }
    auto* to = across.ptr<float>(static_cast<int>(row));
    std::fill(to, to + in.cols, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      for (int u = 0; u < in.cols; ++u) to[u] += kernel[k] * padded[static_cast<std::size_t>(u) + k];
    }
  });
  ParallelFor(context, 0, in.rows, [&](std::int64_t row) {
    auto* to = out.ptr<float>(static_cast<int>(row));
    std::fill(to, to + in.cols, 0.0F);
    for (int k = -radius; k <= radius; ++k) {
      const auto* from = across.ptr<float>(std::clamp(static_cast<int>(row) + k, 0, in.rows - 1));
      const float weight = kernel[static_cast<std::size_t>(k + radius)];
      for (int u = 0; u < in.cols; ++u) to[u] += weight * from[u];
    }
  });
  return out;
}

// Square of the tangent of the angle against the optical axis at a pixel.
double TanSquared(const Camera& camera, double u, double v) {
  const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
  return x * x + y * y;
}

// What one photosite makes of light, as a share of full scale.
double Exposed(const SensorDesign& sensor, double light, float noise) {
  double value = light;
  if (sensor.full_well_e > 0.0) {
    const double electrons = light * sensor.full_well_e;
    const double sigma = std::sqrt(electrons + sensor.read_noise_e * sensor.read_noise_e);
    value = (electrons + sigma * static_cast<double>(noise)) / sensor.full_well_e;
  }
  return std::clamp(value, 0.0, 1.0);
}

std::uint8_t Code(const SensorDesign& sensor, double value) {
  if (sensor.gamma != 1.0) value = std::pow(value, 1.0 / sensor.gamma);
  return static_cast<std::uint8_t>(
      std::lround(255.0 * (sensor.black_level + (1.0 - sensor.black_level) * value)));
}

using Response = std::array<double, 3>;  // of blue, green and red pixels to green light

cv::Mat DigitiseAllColours(const SensorDesign& sensor, const Response& response, const cv::Mat& light,
                           std::uint64_t seed, const Context& context) {
  cv::Mat picture(light.size(), CV_8UC3);
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    const auto* from = light.ptr<float>(static_cast<int>(row));
    auto* to = picture.ptr<cv::Vec3b>(static_cast<int>(row));
    for (int u = 0; u < light.cols; ++u) {
      const auto pixel = static_cast<std::uint64_t>(row * light.cols + u);
      for (int c = 0; c < 3; ++c) {
        const float noise = PixelNoise(seed, 3 * pixel + static_cast<std::uint64_t>(c));
        const double seen = static_cast<double>(from[u]) * response[static_cast<std::size_t>(c)];
        to[u][c] = Code(sensor, Exposed(sensor, seen, noise));
      }
    }
  });
  return picture;
}

// As a camera does it: the mosaic is read with more bits than the picture has, the missing colours are
// interpolated while numbers are still proportional to light, and only then comes gamma.
cv::Mat DigitiseMosaic(const SensorDesign& sensor, const Response& response, const cv::Mat& light,
                       std::uint64_t seed, const Context& context) {
  constexpr int kRawMax = 4095;  // 12 bits
  cv::Mat raw(light.size(), CV_16U);
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    const auto* from = light.ptr<float>(static_cast<int>(row));
    auto* to = raw.ptr<std::uint16_t>(static_cast<int>(row));
    for (int u = 0; u < light.cols; ++u) {
      const auto pixel = static_cast<std::uint64_t>(row * light.cols + u);
      const std::size_t colour = row % 2 == u % 2 ? (row % 2 == 0 ? 2 : 0) : 1;  // RG above GB
      const double value =
          Exposed(sensor, static_cast<double>(from[u]) * response[colour], PixelNoise(seed, pixel));
      to[u] = static_cast<std::uint16_t>(std::lround(kRawMax * value));
    }
  });
  cv::Mat colour;
  cv::demosaicing(raw, colour, cv::COLOR_BayerRGGB2BGR);
  std::array<std::uint8_t, kRawMax + 1> codes{};
  for (int i = 0; i <= kRawMax; ++i) {
    codes[static_cast<std::size_t>(i)] = Code(sensor, static_cast<double>(i) / kRawMax);
  }
  cv::Mat picture(light.size(), CV_8UC3);
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    const auto* from = colour.ptr<cv::Vec3w>(static_cast<int>(row));
    auto* to = picture.ptr<cv::Vec3b>(static_cast<int>(row));
    for (int u = 0; u < light.cols; ++u) {
      for (int c = 0; c < 3; ++c) to[u][c] = codes[std::min<std::size_t>(from[u][c], kRawMax)];
    }
  });
  return picture;
}

}  // namespace

cv::Mat ThroughLens(const VirtualDevice& device, const cv::Mat& light, const Context& context) {
  const Camera& camera = device.camera;
  const double w = camera.width - 1.0, h = camera.height - 1.0;
  const double corner = std::max({TanSquared(camera, 0, 0), TanSquared(camera, w, 0),
                                  TanSquared(camera, 0, h), TanSquared(camera, w, h)});
  cv::Mat image(light.size(), CV_32F);
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    const auto* from = light.ptr<float>(static_cast<int>(row));
    auto* to = image.ptr<float>(static_cast<int>(row));
    for (int u = 0; u < light.cols; ++u) {
      const double t = TanSquared(camera, u, static_cast<double>(row));
      const double cosine_squared = 1.0 / (1.0 + t);
      const double filter = 1.0 - device.description.sensor.filter_falloff * t / corner;
      to[u] = from[u] * static_cast<float>(cosine_squared * cosine_squared * filter);
    }
  });
  return Blur(image, device.description.sensor.psf_sigma_px, context);
}

void AddSpeckle(const SpeckleDesign& speckle, std::uint64_t seed, cv::Mat& light, const Context& context) {
  if (speckle.contrast <= 0.0) return;
  cv::Mat field(light.size(), CV_32F);
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    auto* out = field.ptr<float>(static_cast<int>(row));
    const auto first = static_cast<std::uint64_t>(row * light.cols);
    for (int u = 0; u < light.cols; ++u) out[u] = PixelNoise(seed, first + static_cast<std::uint64_t>(u));
  });
  field = Blur(field, speckle.correlation_px, context);
  // Blurring white noise along both axes scales its deviation by the kernel's squared norm.
  float norm = 1.0F;
  if (speckle.correlation_px >= 0.05) {
    norm = 0.0F;
    for (const float k : GaussKernel(speckle.correlation_px)) norm += k * k;
  }
  const float scale = static_cast<float>(speckle.contrast) / norm;
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    auto* to = light.ptr<float>(static_cast<int>(row));
    const auto* grain = field.ptr<float>(static_cast<int>(row));
    for (int u = 0; u < light.cols; ++u) to[u] *= std::max(0.0F, 1.0F + scale * grain[u]);
  });
}

cv::Mat Digitise(const SensorDesign& sensor, const cv::Mat& light, std::uint64_t seed,
                 const Context& context) {
  const Response response = {sensor.leak_blue, 1.0, sensor.leak_red};
  return sensor.bayer ? DigitiseMosaic(sensor, response, light, seed, context)
                      : DigitiseAllColours(sensor, response, light, seed, context);
}

}  // namespace dorsum
