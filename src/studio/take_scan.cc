// SPDX-License-Identifier: Apache-2.0
#include "studio/take_scan.h"

#include <utility>

#include "captures/names.h"
#include "jobs/capture.h"

namespace dorsum {
namespace {

constexpr double kCaptureShare = 0.7;  // of the whole time that the pictures take, roughly

}  // namespace

std::vector<std::string> StagesOfScan(int lasers) {
  std::vector<std::string> stages = {"dark", kBgHandName};
  for (int k = 0; k < lasers; ++k) stages.push_back(StripesHandName(k));
  stages.emplace_back(kBgHandAfterName);
  stages.emplace_back(kSurfaceStage);
  return stages;
}

Result<TakenScan> TakeScan(Device& device, const std::shared_ptr<const ReadyCalibration>& calibration,
                           const std::string& name, const Context& context) {
  TakenScan taken;
  Context capturing = context;
  capturing.progress = [&](std::string_view stage, double fraction) {
    context.Report(stage, kCaptureShare * fraction);
  };
  DORSUM_ASSIGN_OR_RETURN(TakenCapture images, TakeCapture(device, {}, calibration.get(), capturing));
  taken.last_frame_s = MonotonicSeconds();
  context.Report(kSurfaceStage, kCaptureShare);
  Context computing = context;
  computing.progress = [&](std::string_view, double fraction) {
    context.Report(kSurfaceStage, kCaptureShare + (1.0 - kCaptureShare) * fraction);
  };
  DORSUM_ASSIGN_OR_RETURN(taken.scan,
                          MakeScan(name, {}, std::move(images.images), calibration, {}, computing));
  taken.fingers = JudgeFingers(taken.scan->surface, calibration->calibration.device.camera);
  return taken;
}

}  // namespace dorsum
