// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "simulator/scene_tracer.h"
#include "simulator/view.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// A scene before a device, traced once.
struct Stage {
  SceneTracer tracer;
  View view;
};
Result<Stage> SetStage(const VirtualDevice& device, Scene scene, const Context& context);

// What is switched on before a stage.
struct SceneLight {
  bool leds = false;             // and with them the longer daylight of their exposure
  std::vector<int> lasers = {};  // each once
};

// Light on the sensor (CV_32F, 1 is full scale) of a stage, without noise.
struct SensorLight {
  cv::Mat steady;  // of LEDs and daylight
  cv::Mat laser;   // gets speckle; empty where no laser is on
};
Result<SensorLight> TraceLight(const VirtualDevice& device, const Stage& stage, const SceneLight& on,
                               const Context& context);

// A picture (8-bit BGR) of that light. Speckle stays as long as nothing moves; the sensor's noise is another
// in each frame. The same seeds give the same bytes at any number of threads.
Result<cv::Mat> ExposePicture(const VirtualDevice& device, const SensorLight& light,
                              std::uint64_t speckle_seed, std::uint64_t sensor_seed, const Context& context);

// Both steps in one: under the LEDs, under one laser, and in the dark (daylight only, as the document's
// background pictures of §3.2).
Result<cv::Mat> RenderLeds(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context);
Result<cv::Mat> RenderLaser(const VirtualDevice& device, const Stage& stage, int laser, std::uint64_t seed,
                            const Context& context);
Result<cv::Mat> RenderDark(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context);

}  // namespace dorsum
