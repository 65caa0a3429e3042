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

Result<SensorLight> TraceLight(const VirtualDevice& device, const Stage& stage, const SceneLight& on,
                               const Context& context) {
  const DeviceDescription& d = device.description;
  SensorLight light;
  if (on.leds) {
    light.steady = LedLight(device, stage.tracer, stage.view, context);
    light.steady += AmbientLight(stage.view, d.light.ambient_led);
  } else {
    light.steady = AmbientLight(stage.view, d.light.ambient_laser);
  }
  light.steady = ThroughLens(device, light.steady, context);
  for (const int k : on.lasers) {
    const VirtualLaser& source = device.lasers.at(static_cast<std::size_t>(k));
    const cv::Mat one = LaserLight(source, d.skin, stage.tracer, stage.view, context);
    if (light.laser.empty()) {
      light.laser = one;
    } else {
      light.laser += one;
    }
  }
  if (!light.laser.empty()) light.laser = ThroughLens(device, light.laser, context);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return light;
}

Result<cv::Mat> ExposePicture(const VirtualDevice& device, const SensorLight& light,
                              std::uint64_t speckle_seed, std::uint64_t sensor_seed, const Context& context) {
  const DeviceDescription& d = device.description;
  if (light.laser.empty()) return Digitise(d.sensor, light.steady, sensor_seed, context);
  cv::Mat sum = light.laser.clone();
  AddSpeckle(d.speckle, speckle_seed, sum, context);
  sum += light.steady;
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return Digitise(d.sensor, sum, sensor_seed, context);
}

namespace {

Result<cv::Mat> Render(const VirtualDevice& device, const Stage& stage, const SceneLight& on,
                       std::uint64_t seed, const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const SensorLight light, TraceLight(device, stage, on, context));
  return ExposePicture(device, light, NamedSeed("speckle", seed), NamedSeed("sensor", seed), context);
}

}  // namespace

Result<cv::Mat> RenderLeds(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context) {
  return Render(device, stage, {.leds = true}, seed, context);
}

Result<cv::Mat> RenderLaser(const VirtualDevice& device, const Stage& stage, int laser, std::uint64_t seed,
                            const Context& context) {
  return Render(device, stage, {.lasers = {laser}}, seed, context);
}

Result<cv::Mat> RenderDark(const VirtualDevice& device, const Stage& stage, std::uint64_t seed,
                           const Context& context) {
  return Render(device, stage, {}, seed, context);
}

}  // namespace dorsum
