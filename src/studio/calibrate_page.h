// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/calibrate_model.h"
#include "studio/page.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace dorsum {

class CalibrationViews;
class CoverageView;

// The wizard of the calibration: where it goes, the steps of the series, what to do now with the live picture
// beside it, and what came out.
class CalibratePage : public Page {
  Q_OBJECT

 public:
  CalibratePage(Workbench* workbench, QWidget* parent);

  CalibrateModel* model() { return &model_; }
  void Enter() override;
  void Leave() override;

 private:
  QWidget* MakePlaces();
  QWidget* MakeSide();
  QWidget* MakeSeries();
  void BrowseFolder();
  void BrowseFile();
  void ShowPlaces();
  void ShowSeries();
  void ShowBoards();
  void ShowOutcome();

  CalibrateModel model_;
  QLineEdit *folder_ = nullptr, *file_ = nullptr;
  QPushButton *take_ = nullptr, *calibrate_ = nullptr, *next_ = nullptr, *stop_ = nullptr, *back_ = nullptr;
  QCheckBox* by_itself_ = nullptr;
  QListWidget* steps_ = nullptr;
  QLabel *words_ = nullptr, *seen_ = nullptr, *covered_ = nullptr;
  CoverageView* picture_ = nullptr;
  CalibrationViews* views_ = nullptr;
  QTabWidget* tabs_ = nullptr;
};

}  // namespace dorsum
