// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "studio/surface_colours.h"

namespace dorsum {

// What the colours of a surface mean: a run of colours with numbers in mm, or a swatch for each number.
class ScaleBar : public QWidget {
  Q_OBJECT

 public:
  explicit ScaleBar(QWidget* parent = nullptr);
  void SetScale(const ColourScale& scale);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ColourScale scale_;
};

// Round numbers within [low, high], about `count` of them: steps are 1, 2 or 5 times a power of ten.
std::vector<double> RoundNumbers(double low, double high, int count);
// With as many digits as the step needs.
QString NumberText(double number, double step);

}  // namespace dorsum
