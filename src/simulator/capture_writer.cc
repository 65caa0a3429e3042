// SPDX-License-Identifier: Apache-2.0
#include "simulator/capture_writer.h"

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

Status WriteCapturePictures(const VirtualDevice& device, const Stage& stage, std::uint64_t noise_seed,
                            const std::filesystem::path& dir, const Context& context) {
  DORSUM_RETURN_IF_ERROR(MakeFolder(dir));
  const CameraDesign& camera = device.description.camera;
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat leds,
                          RenderLeds(device, stage, NamedSeed(kBgHandName, noise_seed), context));
  DORSUM_RETURN_IF_ERROR(WritePicture(camera, leds, dir / kBgHandName));
  for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
    const std::string name = StripesHandName(k);
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat stripes,
                            RenderLaser(device, stage, k, NamedSeed(name, noise_seed), context));
    DORSUM_RETURN_IF_ERROR(WritePicture(camera, stripes, dir / name));
  }
  return {};
}

Status WriteCapture(const VirtualDevice& device, Scene scene, std::uint64_t noise_seed,
                    const std::filesystem::path& capture_dir, const std::filesystem::path& truth_dir,
                    const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(const Stage stage, SetStage(device, std::move(scene), context));
  DORSUM_RETURN_IF_ERROR(WriteCapturePictures(device, stage, noise_seed, capture_dir, context));
  if (truth_dir.empty()) return {};
  DORSUM_RETURN_IF_ERROR(MakeFolder(truth_dir));
  return WriteTruth(device, stage, truth_dir, context);
}

}  // namespace dorsum
