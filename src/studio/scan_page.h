// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/page.h"
#include "studio/scan_model.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace dorsum {

class LiveView;
class TurningSurface;

// The operator's page: what to do in large letters, the live picture or the surface, one big button.
class ScanPage : public Page {
  Q_OBJECT

 public:
  ScanPage(Workbench* workbench, QWidget* parent);

  void Enter() override { model_->Activate(); }
  void Leave() override { model_->Deactivate(); }
  ScanModel* model() const { return model_; }

 private:
  void AddControls(QHBoxLayout* row);
  void AddPlaces();
  void Press();  // the big button
  void Update();
  QString ButtonText() const;
  QString StepsText() const;
  QString QualityText() const;
  void ChooseCalibration();

  ScanModel* model_;
  QLabel *sentence_, *steps_, *quality_, *folder_;
  QStackedWidget* stack_;
  LiveView* live_;
  TurningSurface* surface_;
  QPushButton *button_, *repeat_, *choose_;
  QCheckBox* automatic_;
  QLabel* place_label_;
  QComboBox* place_;
};

}  // namespace dorsum
