// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "studio/surface_measurer.h"

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QPushButton;

namespace dorsum {

// The row above a surface: what is shown in which colours, what a click does, and files.
class SurfaceControls : public QWidget {
  Q_OBJECT

 public:
  explicit SurfaceControls(QWidget* parent = nullptr);

  // Offers what such a surface has, and settles on what the person chose last, as far as it has that.
  void Offer(bool mesh, bool points, bool difference);
  void ChooseDifference(const QString& other);
  void ShowState(const SurfaceMeasurer& measurer);

  Shown shown() const;
  ColourBy colours() const;

 signals:
  void ShownChanged();
  void ColoursChanged();  // or another surface to differ from
  void ModeChosen(dorsum::SurfaceMeasurer::Mode mode);
  void ClearWanted();
  void CompareWanted();
  void ExportWanted();

 private:
  void AddChoices(QHBoxLayout* row);
  void AddModes(QHBoxLayout* row);
  void AddFiles(QHBoxLayout* row);
  void RememberChoices();

  QComboBox *show_, *colours_;
  QButtonGroup* modes_;
  QPushButton *clear_, *compare_, *export_;
  int wished_show_ = 0, wished_colours_ = 0;  // as the person chose last; not every surface has them
};

}  // namespace dorsum
