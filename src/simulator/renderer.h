// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

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

// Pictures (8-bit BGR) of a stage: under the LEDs, under one laser, and in the dark (daylight only, as the
// document's background pictures of §3.2). The same seed gives the same bytes at any number of threads.
Result<cv::Mat> RenderLeds(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context);
Result<cv::Mat> RenderLaser(const VirtualDevice& device, const Stage& stage, int laser, std::uint64_t seed,
                            const Context& context);
Result<cv::Mat> RenderDark(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context);

}  // namespace dorsum
