// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTabWidget>
#include <memory>

#include "studio/calibration_outcome.h"

class QListWidget;
class QTreeWidget;

namespace dorsum {

class FittedPicture;

// What came out of a calibration: the verdict on each part with its figures, each board with the arrows of
// reprojection, what the light sheets of each laser leave, and the figures before and after.
class CalibrationViews : public QTabWidget {
  Q_OBJECT

 public:
  explicit CalibrationViews(QWidget* parent = nullptr);

  // None: there is nothing to show yet. `loaded` are the parts of the calibration that is loaded, which has
  // verdicts but no pictures.
  void Show(std::shared_ptr<const CalibrationOutcome> outcome, const std::vector<PartReport>& loaded);

 private:
  void ShowParts(const std::vector<PartReport>& parts, const std::vector<std::string>& warnings);
  void ShowChanges();
  void ChooseBoard(int row);
  void ChooseSheets(int row);

  std::shared_ptr<const CalibrationOutcome> outcome_;
  QTreeWidget *parts_, *changes_;
  QListWidget *board_list_, *sheet_list_;
  FittedPicture *board_, *over_order_, *over_y_;
};

}  // namespace dorsum
