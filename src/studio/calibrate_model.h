// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "calibration/board_coverage.h"
#include "captures/series_plan.h"
#include "studio/calibration_outcome.h"
#include "studio/window_attendant.h"
#include "studio/workbench.h"

namespace dorsum {

struct LiveSeriesSummary;

// A step of the calibration series, as a list shows it.
struct StepRow {
  enum class State { kMissing, kNow, kDone };
  SeriesStep step;
  QString title;
  State state = State::kMissing;
};

// The calibrate page without its widgets: leads through the series of the open device step by step, then
// calibrates from its folder and loads what came out. A series that was broken off goes on where it ended.
class CalibrateModel : public QObject {
  Q_OBJECT

 public:
  explicit CalibrateModel(Workbench* workbench, QObject* parent = nullptr);
  ~CalibrateModel() override;

  // Where the pictures of the series go, and the calibration made from them.
  const std::filesystem::path& folder() const { return folder_; }
  const std::filesystem::path& file() const { return file_; }
  void SetFolder(const std::filesystem::path& folder);
  void SetFile(const std::filesystem::path& file);
  // Below the person's documents, by the device's name.
  void UseDefaultPlaces();

  void Take();  // the series with the open device, from what the folder has already; then Calibrate()
  void Next();  // what was asked for stands
  void Stop();
  void GoOnByItself(bool on);  // of a virtual device
  void Hide(bool hidden);      // nobody sees the page
  void Calibrate();            // from the folder as it is, without a device

  bool taking() const { return taking_; }
  bool waiting() const { return waiting_; }  // for Next()
  bool CanGoByItself() const;
  const QString& words() const { return words_; }  // what to arrange
  const QString& seen() const { return seen_; }    // what was seen last
  const std::vector<StepRow>& steps() const { return steps_; }
  const std::optional<BoardCoverage>& coverage() const { return coverage_; }
  const std::vector<std::vector<cv::Point2f>>& boards() const { return boards_; }  // corners, px

  const std::shared_ptr<const CalibrationOutcome>& outcome() const { return outcome_; }
  bool CanGoBack() const;
  void GoBack();  // to the calibration that the last one replaced

 signals:
  void PlacesChanged();
  void Changed();  // steps, words, whether it runs or waits
  void BoardSeen();
  void PictureReady(const cv::Mat& picture);
  void Calibrated();

 private:
  void Hear(const SeriesNews& news);
  void LookAtFolder();
  void BeTaken(const Result<LiveSeriesSummary>& summary);
  StepRow* Row(const SeriesStep& step);

  Workbench* workbench_;
  std::filesystem::path folder_, file_;
  bool chosen_ = false;  // the places were chosen by the person
  bool taking_ = false, waiting_ = false, by_itself_ = false, hidden_ = false;
  std::shared_ptr<SeriesGate> gate_;
  QString words_, seen_;
  std::vector<StepRow> steps_;
  std::optional<BoardCoverage> coverage_;
  std::vector<std::vector<cv::Point2f>> boards_;
  std::shared_ptr<const CalibrationOutcome> outcome_;
};

}  // namespace dorsum
