// SPDX-License-Identifier: Apache-2.0
#include "jobs/doctor_pictures.h"

#include <cstdio>

#include <opencv2/imgproc.hpp>

#include "captures/green_channel.h"
#include "device/take_picture.h"
#include "imaging/unchanged_part.h"
#include "jobs/capture_checks.h"
#include "stripes/backplane_check.h"
#include "stripes/ridge.h"

namespace dorsum {
namespace {

using Health = DoctorFinding::Health;

class Examination {
 public:
  Examination(Device& device, const ReadyCalibration* calibration, const Context& context,
              std::vector<DoctorFinding>* findings)
      : device_(device), calibration_(calibration), context_(context), findings_(findings) {}

  Status Run() {
    const DeviceDescription& d = device_.description;
    if (!CalibrationFits()) calibration_ = nullptr;
    if (!Take({}, FrameLight::kLaser, "camera", &dark_)) return context_.CheckCancelled();
    Judge(CheckDark(dark_, checks_), "daylight", "little light comes from elsewhere");
    if (!Take(LedChannels(d), FrameLight::kLeds, "LEDs", &leds_)) return context_.CheckCancelled();
    Judge(CheckLeds(leds_, dark_, checks_), "LEDs", "they light the picture");
    for (int k = 0; k < static_cast<int>(d.lasers.size()); ++k) {
      context_.Report("laser " + std::to_string(k), 0.4 + 0.6 * k / static_cast<double>(d.lasers.size()));
      cv::Mat lit;
      const std::string who = "laser " + std::to_string(k);
      if (!Take(LaserChannel(d, k), FrameLight::kLaser, who, &lit)) return context_.CheckCancelled();
      if (Judge(CheckLaser(lit, dark_, k, checks_), who, "it lights its stripes")) CheckPlace(lit, k);
    }
    return context_.CheckCancelled();
  }

 private:
  void Add(Health health, const std::string& subject, const std::string& sentence,
           const std::string& remedy) {
    findings_->push_back({health, subject, sentence, remedy});
  }

  bool Take(const ChannelSet& on, FrameLight light, const std::string& subject, cv::Mat* picture) {
    Result<cv::Mat> taken = TakePicture(device_, on, light, {}, context_);
    if (!taken.ok()) {
      if (taken.error().code != ErrorCode::kCancelled)
        Add(Health::kBroken, subject, taken.error().message, "");
      return false;
    }
    *picture = std::move(taken).value();
    return true;
  }

  bool Judge(const CaptureFinding& finding, const std::string& subject, const std::string& fine) {
    if (finding.ok()) {
      Add(Health::kFine, subject, fine, "");
    } else {
      Add(Health::kBroken, subject, finding.sentence, "");
    }
    return finding.ok();
  }

  bool CalibrationFits() {
    if (calibration_ == nullptr) return false;
    const Camera& camera = calibration_->calibration.device.camera;
    if (device_.frames->size() == cv::Size(camera.width, camera.height)) return true;
    Add(Health::kBroken, "calibration",
        "it is of a camera of " + std::to_string(camera.width) + " x " + std::to_string(camera.height) +
            " pixels",
        "calibrate this device");
    return false;
  }

  // The stripes beside whatever lies on the backplane, against the calibration.
  void CheckPlace(const cv::Mat& lit, int laser) {
    if (calibration_ == nullptr) return;
    const std::string who = "laser " + std::to_string(laser);
    if (calibration_->calibration.device.FindLaser(laser) == nullptr) {
      Add(Health::kNote, who, "the calibration does not know it", "calibrate with all lasers");
      return;
    }
    const cv::Mat empty = UnchangedPart(calibration_->background, leds_).Mask(0.06);
    const LaserStripes stripes = FindRidges(GreenChannel(lit), {}, laser, {}, context_);
    const auto checks = CheckBackplane({stripes}, *calibration_->orders, empty, {});
    char text[128];
    if (checks.empty() || checks[0].shift_px == 0.0) {
      Add(Health::kNote, who, "too little of the backplane is as it was at the calibration to check it",
          "clear the backplane and ask again; if it is clear, calibrate again");
      return;
    }
    std::snprintf(text, sizeof text,
                  "its stripes lie %.2f px from where the calibration has them (%d points)",
                  checks[0].shift_px, checks[0].points);
    if (checks[0].moved) {
      Add(Health::kBroken, who, text, "camera, laser or backplane moved: calibrate again");
    } else {
      Add(Health::kFine, who, text, "");
    }
  }

  Device& device_;
  const ReadyCalibration* calibration_;
  const Context& context_;
  std::vector<DoctorFinding>* findings_;
  CaptureCheckOptions checks_;
  cv::Mat dark_, leds_;
};

}  // namespace

Status LookAtPictures(Device& device, const ReadyCalibration* calibration, const Context& context,
                      std::vector<DoctorFinding>* findings) {
  Status status = Examination(device, calibration, context, findings).Run();
  if (const Status off = device.lights->Set({}); !off.ok()) {
    findings->push_back({Health::kBroken, "light controller", off.error().message, ""});
  }
  return status;
}

}  // namespace dorsum
