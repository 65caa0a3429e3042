// SPDX-License-Identifier: Apache-2.0
#include "simulator/capture_writer.h"

#include <string>
#include <utility>

#include "base/random.h"
#include "captures/names.h"
#include "simulator/truth.h"
#include "simulator/truth_files.h"

namespace dorsum {

Status MakeFolder(const std::filesystem::path& dir) {
  std::error_code ec;
  std::filesystem::create_directories(dir, ec);
  if (ec) return BadInput("cannot make the folder " + dir.string() + ": " + ec.message());
  return {};
}

namespace {

// The scene at its first and, where it moves, its second place.
struct Stages {
  Stage first;
  std::optional<Stage> second;
  int from_laser = 0;

  const Stage& OfLaser(int laser) const { return second && laser >= from_laser ? *second : first; }
  const Stage& Last() const { return second ? *second : first; }
};

Status WritePictures(const VirtualDevice& device, const Stages& stages, bool after, std::uint64_t noise_seed,
                     const std::filesystem::path& dir, const Context& context) {
  DORSUM_RETURN_IF_ERROR(MakeFolder(dir));
  const CameraDesign& camera = device.description.camera;
  const auto write_leds = [&](const Stage& stage, const std::string& name) -> Status {
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat leds,
                            RenderLeds(device, stage, NamedSeed(name, noise_seed), context));
    return WritePicture(camera, leds, dir / name);
  };
  DORSUM_RETURN_IF_ERROR(write_leds(stages.first, kBgHandName));
  for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
    const std::string name = StripesHandName(k);
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat stripes,
                            RenderLaser(device, stages.OfLaser(k), k, NamedSeed(name, noise_seed), context));
    DORSUM_RETURN_IF_ERROR(WritePicture(camera, stripes, dir / name));
  }
  return after ? write_leds(stages.Last(), kBgHandAfterName) : Status{};
}

}  // namespace

Status WriteCapture(const VirtualDevice& device, Scene scene, const CaptureExtras& extras,
                    std::uint64_t noise_seed, const std::filesystem::path& capture_dir,
                    const std::filesystem::path& truth_dir, const Context& context) {
  std::optional<Stage> second;
  if (extras.motion) {
    Scene moved = scene;
    MoveObjects(extras.motion->offset_mm, moved);
    DORSUM_ASSIGN_OR_RETURN(second, SetStage(device, std::move(moved), context));
  }
  DORSUM_ASSIGN_OR_RETURN(Stage first, SetStage(device, std::move(scene), context));
  const Stages stages{std::move(first), std::move(second), extras.motion ? extras.motion->from_laser : 0};
  DORSUM_RETURN_IF_ERROR(WritePictures(device, stages, extras.after, noise_seed, capture_dir, context));
  if (truth_dir.empty()) return {};
  DORSUM_RETURN_IF_ERROR(MakeFolder(truth_dir));
  DORSUM_RETURN_IF_ERROR(WriteSurfaceTruth(stages.first, truth_dir));
  for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
    DORSUM_RETURN_IF_ERROR(WriteStripeTruth(device, stages.OfLaser(k), k, truth_dir, context));
  }
  return {};
}

}  // namespace dorsum
