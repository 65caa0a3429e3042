// SPDX-License-Identifier: Apache-2.0
#include "studio/calibrate_model.h"

#include <QDir>
#include <QPointer>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <utility>

#include "captures/image_file.h"
#include "captures/names.h"
#include "jobs/live_series.h"
#include "studio/library_words.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using State = StepRow::State;
using Thing = SeriesStep::Thing;

QString TitleOf(const SeriesStep& step) {
  switch (step.thing) {
    case Thing::kBoard:
      return CalibrateModel::tr("Chessboard %1 of %2").arg(step.number + 1).arg(kChessViews);
    case Thing::kBackplane:
      return CalibrateModel::tr("Empty backplane");
    case Thing::kBoardOnBackplane:
      return CalibrateModel::tr("Chessboard under laser %1").arg(step.number);
    case Thing::kLines:
      return CalibrateModel::tr("Sheet of lines");
    case Thing::kObject:
      return CalibrateModel::tr("Object of %1 mm").arg(step.height_mm);
    case Thing::kBoardOnObject:
      return CalibrateModel::tr("Board on object, laser %1").arg(step.number);
    case Thing::kBox:
      return CalibrateModel::tr("Box of %1 mm").arg(step.height_mm);
  }
  return {};
}

bool HasPictures(const SeriesStep& step, const fs::path& folder) {
  return std::all_of(step.pictures.begin(), step.pictures.end(), [&](const SeriesPicture& picture) {
    return FindImage(folder, picture.name).has_value();
  });
}

}  // namespace

CalibrateModel::CalibrateModel(Workbench* workbench, QObject* parent)
    : QObject(parent), workbench_(workbench) {
  UseDefaultPlaces();
  const auto other_device = [this] {
    if (taking_) return;
    if (!chosen_) UseDefaultPlaces();
    LookAtFolder();
  };
  connect(&workbench_->device(), &DeviceSession::Opened, this, other_device);
  connect(&workbench_->device(), &DeviceSession::Closed, this, other_device);
  LookAtFolder();
}

CalibrateModel::~CalibrateModel() {
  if (gate_) gate_->Stop();
}

void CalibrateModel::UseDefaultPlaces() {
  const auto& facts = workbench_->device().facts();
  QString name = facts ? QString::fromStdString(facts->description.name) : QString("device");
  name.replace('/', '-');
  const QDir home(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Dorsum/" + name);
  folder_ = home.filePath("calibration").toStdString();
  file_ = home.filePath("calibration.json").toStdString();
  chosen_ = false;
  emit PlacesChanged();
}

void CalibrateModel::SetFolder(const fs::path& folder) {
  if (taking_ || folder == folder_) return;
  folder_ = folder;
  chosen_ = true;
  LookAtFolder();
  emit PlacesChanged();
}

void CalibrateModel::SetFile(const fs::path& file) {
  if (file == file_) return;
  file_ = file;
  chosen_ = true;
  emit PlacesChanged();
}

bool CalibrateModel::CanGoByItself() const {
  const auto& facts = workbench_->device().facts();
  return facts && facts->is_virtual;
}

// The plan of the open device, and what of it an earlier run has left.
void CalibrateModel::LookAtFolder() {
  steps_.clear();
  boards_.clear();
  coverage_.reset();
  if (const auto& facts = workbench_->device().facts()) {
    for (const SeriesStep& step : PlanCalibrationSeries(facts->description)) {
      steps_.push_back({step, TitleOf(step), HasPictures(step, folder_) ? State::kDone : State::kMissing});
    }
    coverage_.emplace(cv::Size(facts->description.camera.width, facts->description.camera.height));
  }
  emit Changed();
  emit BoardSeen();
}

StepRow* CalibrateModel::Row(const SeriesStep& step) {
  const auto found = std::find_if(steps_.begin(), steps_.end(), [&](const StepRow& row) {
    return row.step.pictures.front().name == step.pictures.front().name;
  });
  return found == steps_.end() ? nullptr : &*found;
}

void CalibrateModel::Take() {
  if (taking_) return;
  DeviceSession& device = workbench_->device();
  if (!device.facts()) {
    return workbench_->Fail(UsageError(
        "no device is open; open one on the device page, or calibrate from a folder that holds a series"));
  }
  LookAtFolder();
  taking_ = true;
  waiting_ = false;
  words_ = tr("Looking at what is there already…");
  seen_.clear();
  gate_ = std::make_shared<SeriesGate>();
  gate_->GoOn(by_itself_);
  gate_->Hide(hidden_);
  // The session outlives its thread, this model may not: its own pointer is only looked at in the window's.
  const auto tell = [session = &device, guard = QPointer(this)](const SeriesNews& news) {
    QMetaObject::invokeMethod(
        session,
        [guard, news] {
          if (guard) guard->Hear(news);
        },
        Qt::QueuedConnection);
  };
  LiveSeriesRequest request;
  request.dir = folder_;
  device.Run<LiveSeriesSummary>(
      tr("Taking the calibration series"),
      [gate = gate_, tell, request](Device& d, const Context& context) {
        WindowAttendant attendant(d, gate, tell);
        return TakeCalibrationSeries(d, attendant, request, context);
      },
      [guard = QPointer(this)](const Result<LiveSeriesSummary>& summary) {
        if (guard) guard->BeTaken(summary);
      });
  emit Changed();
}

void CalibrateModel::Hear(const SeriesNews& news) {
  using Kind = SeriesNews::Kind;
  if (news.kind == Kind::kPicture) {
    gate_->PictureTaken();
    return emit PictureReady(news.picture);
  }
  if (news.kind == Kind::kBoard) {
    if (coverage_) coverage_->Add(news.corners);
    boards_.push_back(news.corners);
    return emit BoardSeen();
  }
  StepRow* row = news.kind == Kind::kTold ? nullptr : Row(news.step);
  if (news.kind == Kind::kAsked) {
    words_ = InOwnWords(news.words);
    waiting_ = true;
    if (row != nullptr) row->state = State::kNow;
  } else if (news.kind == Kind::kGoing) {
    waiting_ = false;
  } else if (news.kind == Kind::kTold) {
    seen_ = InOwnWords(news.words);
  } else if (row != nullptr) {
    row->state = State::kDone;
  }
  emit Changed();
}

void CalibrateModel::BeTaken(const Result<LiveSeriesSummary>& summary) {
  taking_ = waiting_ = false;
  for (StepRow& row : steps_) {
    if (row.state == State::kNow) row.state = State::kMissing;
  }
  if (!summary.ok()) {
    words_ = summary.error().code == ErrorCode::kCancelled
                 ? tr("Stopped. What was taken is kept; the series goes on from there.")
                 : tr("The series broke off. What was taken is kept; the series goes on from there.");
    workbench_->Fail(summary.error());
    return emit Changed();
  }
  words_ = tr("All pictures are there. The boards cover %1 % of the picture.")
               .arg(std::lround(100.0 * summary->board_coverage));
  emit Changed();
  Calibrate();
}

void CalibrateModel::Next() {
  if (!waiting_) return;
  waiting_ = false;
  gate_->Next();
  emit Changed();
}

void CalibrateModel::Stop() {
  if (!taking_) return;
  gate_->Stop();
  workbench_->device().Cancel();
}

void CalibrateModel::GoOnByItself(bool on) {
  by_itself_ = on;
  if (gate_) gate_->GoOn(on);
}

void CalibrateModel::Hide(bool hidden) {
  hidden_ = hidden;
  if (gate_) gate_->Hide(hidden);
}

void CalibrateModel::Calibrate() {
  if (workbench_->jobs().busy()) {
    return workbench_->Fail(UsageError("something else is being done; wait for it, or cancel it"));
  }
  std::optional<std::vector<PartReport>> before;
  if (const auto& loaded = workbench_->calibration()) before = loaded->calibration.parts;
  using Outcome = std::shared_ptr<const CalibrationOutcome>;
  workbench_->jobs().Run<Outcome>(
      tr("Calibrating"),
      [dir = folder_, file = file_, before](const Context& context) {
        return CalibrateForWindow(dir, file, before, context);
      },
      [guard = QPointer(this)](const Result<Outcome>& outcome) {
        if (!guard) return;
        if (!outcome.ok()) return guard->workbench_->Fail(outcome.error());
        guard->outcome_ = *outcome;
        emit guard->Calibrated();
        guard->workbench_->LoadCalibration(guard->outcome_->file);
      });
}

bool CalibrateModel::CanGoBack() const {
  std::error_code ec;
  return outcome_ && fs::exists(BeforePath(outcome_->file), ec);
}

void CalibrateModel::GoBack() {
  if (!CanGoBack()) return;
  const fs::path file = outcome_->file;
  std::error_code ec;
  fs::rename(BeforePath(file), file, ec);
  if (ec) {
    return workbench_->Fail(BadInput("cannot put back " + BeforePath(file).string() + ": " + ec.message()));
  }
  fs::path page = file;
  page.replace_extension(".html");
  fs::rename(BeforePath(page), page, ec);  // its report may be gone; the calibration is what counts
  outcome_.reset();
  emit Calibrated();
  workbench_->LoadCalibration(file);
}

}  // namespace dorsum
