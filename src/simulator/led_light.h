// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "simulator/scene_tracer.h"
#include "simulator/view.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Light of all LEDs together that each pixel sends back (CV_32F), with soft shadows, before lens and sensor.
cv::Mat LedLight(const VirtualDevice& device, const SceneTracer& tracer, const View& view,
                 const Context& context);

// Daylight from everywhere: `irradiance` times the albedo.
cv::Mat AmbientLight(const View& view, double irradiance);

}  // namespace dorsum
