// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "studio/surface_measure.h"

namespace dorsum {

// The curve of a section, height over way, both in mm, each with a scale of its own. Says the values under
// the pointer.
class SectionPlot : public QWidget {
  Q_OBJECT

 public:
  explicit SectionPlot(QWidget* parent = nullptr);
  void SetSection(const Section& section);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QRectF Frame() const;
  QPointF At(const Eigen::Vector2d& p) const;
  void PaintAxes(QPainter* painter) const;

  Section section_;
  Eigen::Vector2d low_{0.0, 0.0}, high_{1.0, 1.0};
  std::optional<Eigen::Vector2d> pointed_;
};

}  // namespace dorsum
