// SPDX-License-Identifier: Apache-2.0
#include "jobs/capture.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/files.h"
#include "calibration/calibration_file.h"
#include "captures/names.h"
#include "captures/picture_file.h"
#include "device/device_error.h"
#include "device/take_picture.h"
#include "jobs/capture_checks.h"
#include "jobs/reconstruct.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class Session {
 public:
  Session(Device& device, const CaptureRequest& request, const Context& context)
      : device_(device), request_(request), context_(context) {
    options_.average = request.average;
  }

  Result<CaptureImages> Take(const std::vector<int>& lasers, const ReadyCalibration* ready) {
    for (int attempt = 0;; ++attempt) {
      DORSUM_ASSIGN_OR_RETURN(CaptureImages capture, TakeAll(lasers));
      CaptureFinding finding = CheckRest(capture, checks_, &capture.warnings);
      if (finding.ok()) finding = CheckLasersDiffer(capture, checks_);
      if (finding.ok() && ready != nullptr) {
        DORSUM_ASSIGN_OR_RETURN(finding, CheckAgainstCalibration(capture, *ready, context_));
      }
      if (finding.ok()) return capture;
      if (!finding.CanRetry() || attempt >= request_.retries) return finding.ToError();
      ++retried_;
      context_.Report("again: " + finding.sentence, 0.0);
    }
  }
  int retried() const { return retried_; }

 private:
  // One picture; taken again as long as `check` says that this may help.
  template <class Check>
  Result<cv::Mat> Picture(const std::string& name, const ChannelSet& on, FrameLight light,
                          const Check& check) {
    context_.Report(name, static_cast<double>(done_++) / total_);
    for (int attempt = 0;; ++attempt) {
      DORSUM_ASSIGN_OR_RETURN(cv::Mat picture, TakePicture(device_, on, light, options_, context_));
      const CaptureFinding finding = check(picture);
      if (finding.ok()) return picture;
      if (!finding.CanRetry() || attempt >= request_.retries) return finding.ToError();
      ++retried_;
    }
  }

  Result<cv::Mat> Leds(const std::string& name, const cv::Mat& dark) {
    return Picture(name, LedChannels(device_.description), FrameLight::kLeds,
                   [&](const cv::Mat& picture) { return CheckLeds(picture, dark, checks_); });
  }

  Result<CaptureImages> TakeAll(const std::vector<int>& lasers) {
    done_ = 0;
    total_ = static_cast<double>(lasers.size()) + 3.0;
    CaptureImages capture;
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat dark,
                            Picture("dark", {}, FrameLight::kLaser,
                                    [&](const cv::Mat& picture) { return CheckDark(picture, checks_); }));
    DORSUM_ASSIGN_OR_RETURN(capture.hand, Leds(kBgHandName, dark));
    capture.stripes.resize(static_cast<std::size_t>(lasers.back()) + 1);
    for (const int k : lasers) {
      DORSUM_ASSIGN_OR_RETURN(
          capture.stripes[static_cast<std::size_t>(k)],
          Picture(StripesHandName(k), LaserChannel(device_.description, k), FrameLight::kLaser,
                  [&](const cv::Mat& picture) { return CheckLaser(picture, dark, k, checks_); }));
    }
    DORSUM_ASSIGN_OR_RETURN(capture.hand_after, Leds(kBgHandAfterName, dark));
    return capture;
  }

  Device& device_;
  const CaptureRequest& request_;
  const Context& context_;
  StillOptions options_;
  CaptureCheckOptions checks_;
  int retried_ = 0, done_ = 0;
  double total_ = 1.0;
};

Result<std::vector<int>> LasersToLight(const DeviceDescription& device, std::vector<int> asked) {
  const int count = static_cast<int>(device.lasers.size());
  if (asked.empty()) {
    for (int k = 0; k < count; ++k) asked.push_back(k);
  }
  std::sort(asked.begin(), asked.end());
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  if (asked.front() < 0 || asked.back() >= count) {
    const int wrong = asked.front() < 0 ? asked.front() : asked.back();
    return UsageError("the device has no laser " + std::to_string(wrong) + ": its lasers are 0 to " +
                      std::to_string(count - 1));
  }
  return asked;
}

Status CheckTarget(const fs::path& dir) {
  std::error_code ec;
  if (!fs::exists(dir, ec) || (fs::is_directory(dir, ec) && fs::is_empty(dir, ec))) return {};
  return BadInput(dir.string() + " is there already and not empty; name a new folder");
}

Result<std::optional<ReadyCalibration>> LoadReady(const fs::path& path, const CameraDesign& camera) {
  if (path.empty()) return std::optional<ReadyCalibration>();
  DORSUM_ASSIGN_OR_RETURN(Calibration calibration, ReadCalibration(path));
  const Camera& calibrated = calibration.device.camera;
  if (calibrated.width != camera.width || calibrated.height != camera.height) {
    return BadInput(path.string() + " is of a camera of " + std::to_string(calibrated.width) + " x " +
                    std::to_string(calibrated.height) + " pixels, the device's has " +
                    std::to_string(camera.width) + " x " + std::to_string(camera.height) +
                    "; calibrate this device");
  }
  DORSUM_ASSIGN_OR_RETURN(ReadyCalibration ready, PrepareCalibration(std::move(calibration), path.string()));
  return std::optional(std::move(ready));
}

}  // namespace

Result<TakenCapture> TakeCapture(Device& device, const CaptureRequest& request,
                                 const ReadyCalibration* calibration, const Context& context) {
  if (request.average < 1 || request.average > 64) return UsageError("average must be 1 to 64 frames");
  if (request.retries < 0 || request.retries > 10) return UsageError("retries must be 0 to 10");
  DORSUM_ASSIGN_OR_RETURN(const std::vector<int> lasers, LasersToLight(device.description, request.lasers));
  Session session(device, request, context);
  Result<CaptureImages> images = session.Take(lasers, calibration);
  const Status off = device.lights->Set({});
  if (!images.ok()) return images.error();
  if (!off.ok()) return off.error();
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  return TakenCapture{std::move(images).value(), session.retried()};
}

Result<std::vector<std::string>> SaveCapture(const CameraDesign& camera, const CaptureImages& capture,
                                             const fs::path& out_dir) {
  DORSUM_RETURN_IF_ERROR(CheckTarget(out_dir));
  DORSUM_ASSIGN_OR_RETURN(StagedFolder staged, StagedFolder::Create(out_dir));
  std::vector<std::string> files;
  const auto write = [&](const std::string& name, const cv::Mat& picture) -> Status {
    DORSUM_RETURN_IF_ERROR(WritePictureFile(camera, picture, staged.path() / name));
    files.push_back(name + (camera.format == "png" ? ".png" : ".jpg"));
    return {};
  };
  DORSUM_RETURN_IF_ERROR(write(kBgHandName, capture.hand));
  for (std::size_t k = 0; k < capture.stripes.size(); ++k) {
    if (!capture.stripes[k]) continue;
    DORSUM_RETURN_IF_ERROR(write(StripesHandName(static_cast<int>(k)), *capture.stripes[k]));
  }
  if (capture.hand_after) DORSUM_RETURN_IF_ERROR(write(kBgHandAfterName, *capture.hand_after));
  DORSUM_RETURN_IF_ERROR(staged.Commit());
  return files;
}

Result<CaptureSummary> CaptureToFolder(Device& device, const CaptureRequest& request,
                                       const Context& context) {
  DORSUM_RETURN_IF_ERROR(CheckTarget(request.out_dir));
  DORSUM_ASSIGN_OR_RETURN(const auto ready, LoadReady(request.calibration_path, device.description.camera));
  DORSUM_ASSIGN_OR_RETURN(const TakenCapture taken,
                          TakeCapture(device, request, ready ? &*ready : nullptr, context));
  CaptureSummary summary;
  summary.warnings = device.frames->warnings();
  summary.warnings.insert(summary.warnings.end(), taken.images.warnings.begin(), taken.images.warnings.end());
  if (!ready) {
    summary.warnings.emplace_back(
        "without a calibration it cannot be told whether a hand is there and each laser is the right one");
  }
  summary.retried = taken.retried;
  DORSUM_ASSIGN_OR_RETURN(summary.files,
                          SaveCapture(device.description.camera, taken.images, request.out_dir));
  return summary;
}

}  // namespace dorsum
