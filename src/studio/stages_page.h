// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jobs/reconstruct_options.h"
#include "studio/page.h"
#include "studio/stage_collector.h"

class QLabel;
class QLayout;
class QListWidget;
class QPushButton;
class QTimer;

namespace dorsum {

class OptionBox;
class OptionPanel;
class PictureView;

// Every intermediate image of the chain, the document's beside ours, and the parameters that make them.
class StagesPage : public Page {
  Q_OBJECT

 public:
  StagesPage(Workbench* workbench, QWidget* parent);

  void Enter() override;
  void Leave() override;

  OptionPanel* options();
  const std::shared_ptr<const StageComparison>& comparison() const { return comparison_; }

 signals:
  void Compared();  // comparison() is of the present scan and parameters

 private:
  QLayout* MakeState();
  QWidget* MakeViews();
  void Want();   // the comparison is to be made anew
  void Start();  // makes it, if wanted, shown and possible now
  void TakeComparison(const std::shared_ptr<const StageComparison>& now);
  void ShowStage();
  QString Words() const;  // why there is nothing to see
  QString State() const;

  ReconstructOptions options_;
  OptionTable table_;
  std::shared_ptr<const StageComparison> comparison_, before_;  // before_: of the same scan
  std::string stage_ = "mask/mask";                             // key of the one that is looked at
  bool here_ = false, wanted_ = false, running_ = false;
  bool stale_ = true;  // comparison_ is not of the present scan and parameters

  OptionBox* box_;
  QListWidget* list_;
  QLabel* state_;
  QPushButton *before_button_, *again_;
  QTimer* timer_;
  PictureView *classic_, *ours_;
  QLabel *classic_figures_, *ours_figures_;
};

}  // namespace dorsum
