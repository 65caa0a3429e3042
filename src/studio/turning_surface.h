// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "studio/job_runner.h"
#include "studio/workbench.h"

namespace dorsum {

// A surface that turns, from pictures that are painted beside the window, one view after the other; it goes
// round once all of them are there.
class TurningSurface : public QWidget {
  Q_OBJECT

 public:
  explicit TurningSurface(QWidget* parent = nullptr);
  void Show(std::shared_ptr<const Scan> scan);  // none: nothing
  int views() const { return static_cast<int>(views_.size()); }
  QSize minimumSizeHint() const override { return {240, 180}; }

 signals:
  void Drawn();  // the first picture of a surface is on the screen

 protected:
  void paintEvent(QPaintEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void PaintNext();

  std::shared_ptr<const Scan> scan_;
  std::vector<QImage> views_;
  int shown_ = 0;
  QTimer turn_;
  JobRunner painting_;  // last: it ends first
};

// What a page puts where a surface is to turn.
TurningSurface* MakeSurfaceWidget(QWidget* parent);

}  // namespace dorsum
