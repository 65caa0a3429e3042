// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "studio/device_model.h"
#include "studio/fitted_picture.h"
#include "studio/page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace dorsum {

// Chooses and opens a device, shows its live picture, switches its lights by hand, says how its camera is set
// and examines it.
class DevicePage : public Page {
  Q_OBJECT

 public:
  DevicePage(Workbench* workbench, QWidget* parent);

  DeviceModel* model() { return &model_; }
  void Enter() override;
  void Leave() override;

 private:
  QWidget* MakeChooser();
  QWidget* MakeLights();
  QWidget* MakeTables();
  void Browse();
  void ShowDevice();
  void ShowLights();
  void ShowReport();

  DeviceModel model_;
  bool entered_ = false;
  QComboBox* which_ = nullptr;
  QLabel *state_ = nullptr, *lit_ = nullptr, *safety_ = nullptr;
  QPushButton *close_ = nullptr, *all_off_ = nullptr;
  QVBoxLayout* rows_ = nullptr;
  std::vector<QPushButton*> toggles_;
  FittedPicture* picture_;
  QTreeWidget *settings_ = nullptr, *findings_ = nullptr;
};

}  // namespace dorsum
