// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_scan.h"

#include <utility>

#include "calibration/calibration_file.h"
#include "captures/capture.h"
#include "jobs/campaign_names.h"

namespace dorsum {

namespace fs = std::filesystem;

Result<std::shared_ptr<const Scan>> ScanOfCapture(const CampaignCapture& capture, const fs::path& dir,
                                                  const Context& context) {
  if (capture.stored.calibration.empty()) {
    return BadInput(
        capture.Name() +
        " has no calibration, so that there is no surface of it; give the campaign the device's with "
        "the next capture, and take this one again");
  }
  const fs::path json = CalibrationFile(dir, capture.stored.calibration);
  DORSUM_ASSIGN_OR_RETURN(Calibration calibration, ReadCalibration(json));
  DORSUM_ASSIGN_OR_RETURN(ReadyCalibration ready, PrepareCalibration(std::move(calibration), json.string()));
  const Camera& camera = ready.calibration.device.camera;
  const fs::path folder = capture.Folder(dir);
  DORSUM_ASSIGN_OR_RETURN(CaptureImages images,
                          LoadCapture(folder, {camera.width, camera.height}, capture.stored.lasers));
  return MakeScan(capture.Name(), folder, std::move(images),
                  std::make_shared<const ReadyCalibration>(std::move(ready)), {}, context);
}

}  // namespace dorsum
