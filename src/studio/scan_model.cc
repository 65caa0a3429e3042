// SPDX-License-Identifier: Apache-2.0
#include "studio/scan_model.h"

#include <QDateTime>
#include <QPointer>
#include <QStandardPaths>
#include <utility>

#include "captures/names.h"
#include "device/virtual_bench.h"
#include "jobs/capture.h"
#include "studio/virtual_calibration.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSurfaceStage = "surface";

fs::path Standard(QStandardPaths::StandardLocation which) {
  return QStandardPaths::writableLocation(which).toStdString();
}

QString StepOfLaser(int laser) { return QString::fromStdString(StripesHandName(laser)); }

}  // namespace

ScanModel::ScanModel(Workbench* workbench, QObject* parent)
    : QObject(parent),
      workbench_(workbench),
      folder_(Standard(QStandardPaths::DocumentsLocation) / "Dorsum" / "captures"),
      cache_(Standard(QStandardPaths::CacheLocation)) {
  DeviceSession* device = &workbench_->device();
  connect(device, &DeviceSession::Opened, this, &ScanModel::OnOpened);
  connect(device, &DeviceSession::Closed, this, [this] { Go(ScanState::kNoDevice); });
  connect(device, &DeviceSession::Failed, this,
          [this] { Go(workbench_->device().facts() ? ScanState::kLost : ScanState::kNoDevice); });
  connect(device, &DeviceSession::FrameReady, this, &ScanModel::OnFrame);
  connect(device, &DeviceSession::Progressed, this, &ScanModel::OnProgress);
  connect(workbench_, &Workbench::CalibrationChanged, this, [this] {
    advisor_.reset();
    if (IsLive()) GoLive();
  });
  if (device->facts()) OnOpened();
}

QString ScanModel::Sentence() const {
  switch (state_) {
    case ScanState::kNoDevice:
      return tr("No device is open");
    case ScanState::kLost:
      return tr("The device does not answer: look at its cables");
    case ScanState::kNoCalibration:
      return workbench_->calibration() ? tr("The calibration is of another device")
                                       : tr("This device needs its calibration first");
    case ScanState::kCalibrating:
      return tr("The virtual device calibrates itself");
    case ScanState::kCapturing:
      return again_.isEmpty() ? tr("Hold still") : tr("Once more: hold still");
    case ScanState::kComputing:
      return tr("Thank you: you may take the hand away");
    case ScanState::kShown:
      return tr("Is it good?");
    case ScanState::kKept:
      return tr("Kept");
    case ScanState::kPreview:
    case ScanState::kReady:
      break;
  }
  switch (view_.advice) {
    case Advice::kPutHandDown:
      return tr("Put your hand down");
    case Advice::kLightChanged:
      return tr("The light has changed: calibrate again");
    case Advice::kMoveLeft:
      return tr("Move the hand to the left");
    case Advice::kMoveRight:
      return tr("Move the hand to the right");
    case Advice::kMoveUp:
      return tr("Move the hand up");
    case Advice::kMoveDown:
      return tr("Move the hand down");
    case Advice::kSpreadFingers:
      return tr("Spread the fingers");
    case Advice::kHoldStill:
      return tr("Hold still");
    case Advice::kGood:
      break;
  }
  return tr("Good: hold still");
}

bool ScanModel::is_virtual() const {
  const auto& facts = workbench_->device().facts();
  return facts && facts->is_virtual;
}

bool ScanModel::IsLive() const {
  return state_ == ScanState::kNoCalibration || state_ == ScanState::kPreview || state_ == ScanState::kReady;
}

bool ScanModel::CalibrationFits() const {
  const auto& facts = workbench_->device().facts();
  const auto& ready = workbench_->calibration();
  if (!facts || !ready) return false;
  const CameraDesign& camera = facts->description.camera;
  return ready->background.size() == cv::Size(camera.width, camera.height) &&
         ready->calibration.device.lasers.size() == facts->description.lasers.size();
}

void ScanModel::Go(ScanState state) {
  state_ = state;
  if (!IsLive()) workbench_->device().StopPreview();
  emit Changed();
}

void ScanModel::GoLive() {
  const auto& facts = workbench_->device().facts();
  if (!facts) return Go(ScanState::kNoDevice);
  view_ = {};
  if (active_) workbench_->device().StartPreview(LedChannels(facts->description), FrameLight::kLeds);
  Go(CalibrationFits() ? ScanState::kPreview : ScanState::kNoCalibration);
}

void ScanModel::Activate() {
  active_ = true;
  if (IsLive()) GoLive();
}

void ScanModel::Deactivate() {
  active_ = false;
  workbench_->device().StopPreview();
}

fs::path ScanModel::CalibrationDir() const {
  return VirtualCalibrationDir(cache_, workbench_->device().facts()->name);
}

// A virtual device that was calibrated before, or another one than the calibration is of, takes its own.
void ScanModel::OnOpened() {
  advisor_.reset();
  armed_ = true;
  GoLive();
  if (!is_virtual() || workbench_->jobs().busy()) return;
  const fs::path own = CalibrationDir() / "calibration.json", now = workbench_->calibration_path();
  const bool chosen =
      workbench_->calibration() && now.parent_path().parent_path() != own.parent_path().parent_path();
  std::error_code ec;
  if (!chosen && now != own && fs::exists(own, ec)) workbench_->LoadCalibration(own);
}

void ScanModel::SetAutomatic(bool automatic) {
  automatic_ = automatic;
  if (automatic_ && armed_ && state_ == ScanState::kReady) Scan();
}

void ScanModel::OnFrame(const cv::Mat& picture) {
  if (!active_ || !IsLive() || looking_.busy()) return;
  if (!CalibrationFits()) {
    view_ = {};
    view_.picture = picture;
    emit ViewChanged();
    return;
  }
  if (!advisor_) advisor_ = std::make_shared<HandAdvisor>(workbench_->calibration()->background);
  if (picture.size() != advisor_->size()) return;
  looking_.Run<HandView>(
      "look",
      [advisor = advisor_, picture, now = MonotonicSeconds()](const Context&) -> Result<HandView> {
        return advisor->Look(picture, now);
      },
      [this](Result<HandView> view) { OnViewed(std::move(view).value()); });
}

void ScanModel::OnViewed(HandView view) {
  if (state_ != ScanState::kPreview && state_ != ScanState::kReady) return;
  view_ = std::move(view);
  if (view_.advice != Advice::kGood) armed_ = true;
  const bool ready = view_.advice == Advice::kGood && view_.rested_s >= kRest_s;
  emit ViewChanged();
  Go(ready ? ScanState::kReady : ScanState::kPreview);
  if (ready && automatic_ && armed_) Scan();
}

Result<ScanModel::Taken> ScanModel::TakeScan(Device& device,
                                             const std::shared_ptr<const ReadyCalibration>& calibration,
                                             const std::string& name, const Context& context) {
  Taken taken;
  double last_frame_s = 0.0;
  Context capturing = context;
  capturing.progress = [&](std::string_view stage, double fraction) {
    context.Report(stage, 0.7 * fraction);
  };
  DORSUM_ASSIGN_OR_RETURN(TakenCapture images, TakeCapture(device, {}, calibration.get(), capturing));
  last_frame_s = MonotonicSeconds();
  context.Report(kSurfaceStage, 0.7);
  Context computing = context;
  computing.progress = [&](std::string_view, double fraction) {
    context.Report(kSurfaceStage, 0.7 + 0.3 * fraction);
  };
  DORSUM_ASSIGN_OR_RETURN(taken.scan,
                          MakeScan(name, {}, std::move(images.images), calibration, {}, computing));
  taken.fingers = JudgeFingers(taken.scan->surface, calibration->calibration.device.camera);
  taken.last_frame_s = last_frame_s;
  return taken;
}

void ScanModel::Scan() {
  if (state_ != ScanState::kPreview && state_ != ScanState::kReady) return;
  again_.clear();
  steps_ = {"dark", kBgHandName};
  const auto& facts = workbench_->device().facts();
  for (std::size_t k = 0; k < facts->description.lasers.size(); ++k) {
    steps_ << StepOfLaser(static_cast<int>(k));
  }
  steps_ << kBgHandAfterName << kSurfaceStage;
  steps_done_ = 0;
  armed_ = false;
  Go(ScanState::kCapturing);
  const std::string name = QDateTime::currentDateTime().toString("yyyy-MM-dd_HH-mm-ss").toStdString();
  workbench_->device().Run<Taken>(
      tr("Scanning"),
      [calibration = workbench_->calibration(), name](Device& device, const Context& context) {
        return TakeScan(device, calibration, name, context);
      },
      [self = QPointer<ScanModel>(this)](Result<Taken> taken) {
        if (self) self->OnTaken(std::move(taken));
      });
}

void ScanModel::OnProgress(const QString& stage) {
  if (state_ != ScanState::kCapturing && state_ != ScanState::kComputing) return;
  const bool again = stage.startsWith("again: ");
  const qsizetype step = steps_.indexOf(stage);
  if (again) {
    again_ = stage;
  } else if (step < 0 || (step == steps_done_ && step > 0 && state_ == ScanState::kComputing)) {
    return;
  } else {
    steps_done_ = static_cast<int>(step);
  }
  Go(stage == kSurfaceStage ? ScanState::kComputing : ScanState::kCapturing);
}

void ScanModel::OnTaken(Result<Taken> taken) {
  if (!taken.ok()) return OnFailed(taken.error());
  fingers_ = taken->fingers;
  steps_done_ = static_cast<int>(steps_.size());
  taken_ = taken->scan;
  workbench_->SetScan(taken_);
  wait_s_ = MonotonicSeconds() - taken->last_frame_s;
  Go(ScanState::kShown);
}

void ScanModel::OnFailed(const Error& error) {
  workbench_->Fail(error);
  steps_done_ = 0;
  if (error.code == ErrorCode::kDevice) return Go(ScanState::kLost);
  GoLive();
}

void ScanModel::Cancel() {
  const bool task =
      state_ == ScanState::kCapturing || state_ == ScanState::kComputing || state_ == ScanState::kCalibrating;
  if (task) workbench_->device().Cancel();
}

void ScanModel::Keep() {
  const std::shared_ptr<const dorsum::Scan> scan = taken_;
  if (state_ != ScanState::kShown || saving_.busy() || !workbench_->device().facts()) return;
  const CameraDesign camera = workbench_->device().facts()->description.camera;
  saving_.Run<std::shared_ptr<const dorsum::Scan>>(
      tr("Keeping the capture"),
      [scan, camera,
       dir = folder_ / scan->name](const Context&) -> Result<std::shared_ptr<const dorsum::Scan>> {
        DORSUM_ASSIGN_OR_RETURN(const auto files, SaveCapture(camera, scan->capture, dir));
        auto kept = std::make_shared<dorsum::Scan>(*scan);
        kept->folder = dir;
        return std::shared_ptr<const dorsum::Scan>(std::move(kept));
      },
      [this](Result<std::shared_ptr<const dorsum::Scan>> kept) {
        if (!kept.ok()) return workbench_->Fail(kept.error());
        if (workbench_->scan() == taken_) workbench_->SetScan(*kept);
        taken_ = *kept;
        Go(ScanState::kKept);
        emit Kept(QString::fromStdString((*kept)->folder.string()));
      });
}

void ScanModel::Repeat() {
  if (state_ == ScanState::kShown || state_ == ScanState::kKept) GoLive();
}

void ScanModel::Reconnect() {
  const auto& facts = workbench_->device().facts();
  if (state_ == ScanState::kLost && facts) workbench_->device().Open(std::string(facts->name));
}

void ScanModel::Place(const QString& scene) {
  if (!is_virtual()) return;
  workbench_->device().Run<bool>(
      tr("Laying something before the device"),
      [scene = scene.toStdString()](Device& device, const Context&) -> Result<bool> {
        if (!device.bench) return UsageError("this device is not virtual");
        DORSUM_RETURN_IF_ERROR(device.bench->PlaceNamed(scene));
        return true;
      },
      [self = QPointer<ScanModel>(this)](const Result<bool>& placed) {
        if (!self) return;
        self->armed_ = true;
        if (!placed.ok()) self->workbench_->Fail(placed.error());
      });
}

void ScanModel::CalibrateVirtual() {
  if (!is_virtual() || !IsLive()) return;
  Go(ScanState::kCalibrating);
  workbench_->device().Run<fs::path>(
      tr("Calibrating the virtual device"),
      [dir = CalibrationDir()](Device& device, const Context& context) {
        return CalibrateVirtualDevice(device, dir, context);
      },
      [self = QPointer<ScanModel>(this)](Result<fs::path> file) {
        if (!self) return;
        if (!file.ok()) return self->OnFailed(file.error());
        self->GoLive();
        self->workbench_->LoadCalibration(*file);
      });
}

}  // namespace dorsum
