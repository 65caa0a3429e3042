// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "studio/hand_advice.h"
#include "studio/scaled_picture.h"

namespace dorsum {

// The live picture with the hand's outline over it: amber while something is to be
// changed, green when all is well.
class LiveView : public QWidget {
  Q_OBJECT

 public:
  explicit LiveView(QWidget* parent = nullptr);
  void Show(const HandView& view);
  QSize sizeHint() const override { return {640, 480}; }
  QSize minimumSizeHint() const override { return {240, 180}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  HandView view_;
  ScaledPicture picture_;
};

}  // namespace dorsum
