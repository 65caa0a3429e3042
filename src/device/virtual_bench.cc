// SPDX-License-Identifier: Apache-2.0
#include "device/virtual_bench.h"

#include <utility>
#include <vector>

#include "base/random.h"
#include "captures/picture_file.h"
#include "simulator/disturbance.h"
#include "simulator/named_scene.h"
#include "simulator/scene_modifiers.h"
#include "simulator/series_scenes.h"

namespace dorsum {
namespace {

SceneLight LightOf(const DeviceDescription& description, const ChannelSet& on) {
  SceneLight light;
  for (const LedDesign& led : description.leds) {
    light.leds = light.leds || on.test(static_cast<std::size_t>(led.channel));
  }
  for (std::size_t k = 0; k < description.lasers.size(); ++k) {
    const int channel = description.lasers[k].channel;
    const auto bit = channel < 0 ? k : static_cast<std::size_t>(channel);
    if (on.test(bit)) light.lasers.push_back(static_cast<int>(k));
  }
  return light;
}

}  // namespace

VirtualBench::VirtualBench(const DeviceDescription& description, const std::string& seed, int threads)
    : device_(BuildVirtualDevice(description, NamedSeed(seed))), now_(device_) {
  context_.threads = threads;
  scene_.parts.push_back(Backplane());
}

void VirtualBench::SetScene(Scene scene) {
  scene_ = std::move(scene);
  moved_.reset();
  stage_.reset();
  light_.clear();
}

void VirtualBench::Place(Scene scene, const std::string& moment) {
  const std::lock_guard lock(mutex_);
  now_ = device_;
  moment_ = moment;
  SetScene(std::move(scene));
}

Status VirtualBench::PlaceSeries(const SeriesStep& step) {
  DORSUM_ASSIGN_OR_RETURN(Scene scene, BuildSeriesScene(device_, step));
  Place(std::move(scene), step.pictures.empty() ? "series" : "series/" + step.pictures.front().name);
  return {};
}

Status VirtualBench::PlaceNamed(const std::string& text) {
  DORSUM_ASSIGN_OR_RETURN(const SceneName name, ParseSceneName(text));
  const int lasers = static_cast<int>(device_.lasers.size());
  DORSUM_RETURN_IF_ERROR(CheckLasers(name.modifiers, lasers));
  const std::string moment = "capture/" + name.folder;
  const std::uint64_t drawn = NamedSeed(moment, seed());
  Place(BuildNamedScene(device_, name, seed(), seed()), moment);
  const std::lock_guard lock(mutex_);
  now_ = Disturb(device_, name.modifiers, drawn);
  if (const std::optional<Motion> motion = MotionOf(name.modifiers, lasers, drawn)) {
    moved_ = scene_;
    MoveObjects(motion->offset_mm, *moved_);
    move_from_laser_ = motion->from_laser;
  }
  return {};
}

void VirtualBench::Switch(const ChannelSet& on) {
  const std::lock_guard lock(mutex_);
  on_ = on;
  const std::vector<int> lasers = LightOf(device_.description, on).lasers;
  if (moved_ && !lasers.empty() && lasers.back() >= move_from_laser_) SetScene(*std::exchange(moved_, {}));
}

ChannelSet VirtualBench::On() const {
  const std::lock_guard lock(mutex_);
  return on_;
}

Result<const SensorLight*> VirtualBench::LightNow() {
  if (!stage_) {
    DORSUM_ASSIGN_OR_RETURN(Stage stage, SetStage(now_, scene_, context_));
    stage_.emplace(std::move(stage));
  }
  const auto found = light_.find(on_.to_ullong());
  if (found != light_.end()) return &found->second;
  DORSUM_ASSIGN_OR_RETURN(SensorLight light,
                          TraceLight(now_, *stage_, LightOf(device_.description, on_), context_));
  return &light_.emplace(on_.to_ullong(), std::move(light)).first->second;
}

Result<cv::Mat> VirtualBench::Expose() {
  const std::lock_guard lock(mutex_);
  DORSUM_ASSIGN_OR_RETURN(const SensorLight* light, LightNow());
  const std::uint64_t moment = NamedSeed(moment_, seed());
  const std::uint64_t frame = NamedSeed("frame" + std::to_string(frames_++), moment);
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat picture,
                          ExposePicture(now_, *light, NamedSeed("speckle" + on_.to_string(), moment),
                                        NamedSeed("sensor", frame), context_));
  return ThroughStream(device_.description.camera, picture);
}

}  // namespace dorsum
