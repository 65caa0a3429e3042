// SPDX-License-Identifier: Apache-2.0
#include "studio/scan_model.h"

#include <QDateTime>
#include <QPointer>
#include <QStandardPaths>
#include <utility>

#include "jobs/capture.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

fs::path Documents() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation).toStdString();
}

}  // namespace

ScanModel::ScanModel(Workbench* workbench, QObject* parent)
    : QObject(parent),
      workbench_(workbench),
      virtual_(workbench),
      folder_(Documents() / "Dorsum" / "captures") {
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
  connect(&virtual_, &VirtualSession::Placed, this, [this] { armed_ = true; });
  connect(&virtual_, &VirtualSession::Failed, this, &ScanModel::OnFailed);
  connect(&virtual_, &VirtualSession::Calibrated, this, [this](const fs::path& file) {
    GoLive();
    workbench_->LoadCalibration(file);
  });
  if (device->facts()) OnOpened();
}

QString ScanModel::Sentence() const {
  return ScanSentence(state_, view_.advice, workbench_->calibration() != nullptr, !again_.isEmpty());
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

void ScanModel::OnOpened() {
  advisor_.reset();
  armed_ = true;
  GoLive();
  virtual_.LoadOwnCalibration();
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

void ScanModel::Scan() {
  if (state_ != ScanState::kPreview && state_ != ScanState::kReady) return;
  again_.clear();
  steps_.clear();
  const auto lasers = static_cast<int>(workbench_->device().facts()->description.lasers.size());
  for (const std::string& stage : StagesOfScan(lasers)) steps_ << QString::fromStdString(stage);
  steps_done_ = 0;
  armed_ = false;
  Go(ScanState::kCapturing);
  const std::string name = QDateTime::currentDateTime().toString("yyyy-MM-dd_HH-mm-ss").toStdString();
  workbench_->device().Run<TakenScan>(
      tr("Scanning"),
      [calibration = workbench_->calibration(), name](Device& device, const Context& context) {
        return TakeScan(device, calibration, name, context);
      },
      [self = QPointer<ScanModel>(this)](Result<TakenScan> taken) {
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

void ScanModel::OnTaken(Result<TakenScan> taken) {
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

void ScanModel::CalibrateVirtual() {
  if (!is_virtual() || !IsLive()) return;
  Go(ScanState::kCalibrating);
  virtual_.Calibrate();
}

}  // namespace dorsum
