// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "base/result.h"
#include "captures/series_plan.h"
#include "device/lights.h"
#include "simulator/renderer.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// The virtual device with what stands before it and which of its lights are on: what its camera and its
// controller share. Safe to use from several threads.
class VirtualBench {
 public:
  // `seed`: any text; names the true device, its mounting errors and its noise, as in `dorsum simulate`.
  VirtualBench(const DeviceDescription& description, const std::string& seed, int threads);

  const VirtualDevice& device() const { return device_; }
  std::uint64_t seed() const { return device_.seed; }

  // Puts a scene before the device as it was calibrated. `moment` names its speckle and noise.
  void Place(Scene scene, const std::string& moment);
  // The arrangement of a step of the calibration series.
  Status PlaceSeries(const SeriesStep& step);
  // A scene by name (simulator/named_scene.h): "hand:woman:right:anna", "box25.5+knocked1". An object that
  // moves does so when its laser is first switched on.
  Status PlaceNamed(const std::string& text);

  void Switch(const ChannelSet& on);
  ChannelSet On() const;
  // What the camera sees now; another call is another frame.
  Result<cv::Mat> Expose();

 private:
  void SetScene(Scene scene);
  Result<const SensorLight*> LightNow();

  VirtualDevice device_;
  Context context_;
  mutable std::mutex mutex_;  // guards all below
  ChannelSet on_;
  std::string moment_ = "empty";
  VirtualDevice now_;  // device_ as the scene has disturbed it
  Scene scene_;
  std::optional<Scene> moved_;  // scene_ from the time when move_from_laser_ or a later one is on
  int move_from_laser_ = 0;
  std::optional<Stage> stage_;                       // of scene_, traced when it is first needed
  std::map<unsigned long long, SensorLight> light_;  // of stage_, by channels
  std::uint64_t frames_ = 0;
};

}  // namespace dorsum
