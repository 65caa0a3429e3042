// SPDX-License-Identifier: Apache-2.0
#include "simulator/renderer.h"

#include "base/random.h"
#include "simulator/laser_light.h"
#include "simulator/led_light.h"
#include "simulator/sensor.h"

namespace dorsum {

Result<Stage> SetStage(const VirtualDevice& device, Scene scene, const Context& context) {
  SceneTracer tracer(std::move(scene));
  DORSUM_ASSIGN_OR_RETURN(View view, TraceView(device.camera, tracer, context));
  return Stage{std::move(tracer), std::move(view)};
}

Result<cv::Mat> RenderLeds(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context) {
  cv::Mat light = LedLight(device, stage.tracer, stage.view, context);
  light += AmbientLight(stage.view, device.description.light.ambient_led);
  light = ThroughLens(device, light, context);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return Digitise(device.description.sensor, light, NamedSeed("sensor", seed), context);
}

Result<cv::Mat> RenderLaser(const VirtualDevice& device, const Stage& stage, int laser, std::uint64_t seed,
                            const Context& context) {
  const VirtualLaser& source = device.lasers.at(static_cast<std::size_t>(laser));
  const DeviceDescription& d = device.description;
  cv::Mat light = ThroughLens(device, LaserLight(source, d.skin, stage.tracer, stage.view, context), context);
  AddSpeckle(d.speckle, NamedSeed("speckle", seed), light, context);
  light += ThroughLens(device, AmbientLight(stage.view, d.light.ambient_laser), context);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return Digitise(d.sensor, light, NamedSeed("sensor", seed), context);
}

Result<cv::Mat> RenderDark(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context) {
  const cv::Mat light =
      ThroughLens(device, AmbientLight(stage.view, device.description.light.ambient_laser), context);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return Digitise(device.description.sensor, light, NamedSeed("sensor", seed), context);
}

}  // namespace dorsum
