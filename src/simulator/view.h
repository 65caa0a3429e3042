// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "base/context.h"
#include "geometry/camera.h"
#include "simulator/scene_tracer.h"

namespace dorsum {

// What light needs to know of one seen surface point.
struct SurfaceSample {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();       // for shading
  Eigen::Vector3f face_normal = Eigen::Vector3f::UnitZ();  // for shadow rays
  float albedo = 0.0F;
  float gloss = 0.0F;  // Paint::gloss and ScenePart::shininess
  float shininess = 0.0F;
  std::int16_t part = -1;  // of the scene; -1: the ray left the scene
  Material material = Material::kBackplane;
};

// Everything the camera sees of a scene, traced once and used by the pictures of all lights. One sample per
// pixel, at its centre; where the surface changes within a pixel's surroundings, a grid of finer ones that
// replaces it in pictures (and in nothing else: truth is what the centre sees).
struct View {
  static constexpr int kFineSide = 4;
  static constexpr int kFineCount = kFineSide * kFineSide;
  struct FinePixel {
    std::uint32_t pixel = 0;  // row * width + column
    std::array<SurfaceSample, kFineCount> samples;
  };

  int width = 0, height = 0;
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();  // the camera's centre, for highlights
  std::vector<SurfaceSample> centre;              // row by row
  std::vector<FinePixel> fine;                    // by ascending pixel

  const SurfaceSample& At(int column, int row) const {
    return centre[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

// The sample at an image point (px), with a footprint of `share` of a pixel.
SurfaceSample SampleAt(const Camera& camera, const SceneTracer& tracer, const Eigen::Vector2d& pixel,
                       double share);

Result<View> TraceView(const Camera& camera, const SceneTracer& tracer, const Context& context);

}  // namespace dorsum
