// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "studio/surface_scene.h"

namespace dorsum {

// An image of a capture with the stripes that were found in it. Wheel or +/- zooms, dragging or arrows move,
// Home shows all again. Places are px of the captured image.
class ImageView : public QWidget {
  Q_OBJECT

 public:
  explicit ImageView(QWidget* parent = nullptr);

  void SetImage(const QImage& image);  // null: nothing is behind the stripes
  // The stripes of `laser`, or of all.
  void SetStripes(const SurfacePoints& points, std::optional<int> laser);
  void SetHighlight(const QPolygonF& stripe, std::optional<QPointF> place);
  QSize sizeHint() const override;

  QPointF ToWidget(const QPointF& image) const;
  QPointF ToImage(const QPointF& widget) const;
  std::size_t stripes() const { return stripes_.size(); }

 signals:
  void Aimed(const QPointF& pixel, double reach_px);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double Scale() const;
  void ZoomAt(const QPointF& widget, double factor);
  void Redraw();  // image or stripes changed, or where they are seen

  QImage image_;
  QSizeF size_;  // px; of the image, or what the stripes span
  std::vector<std::pair<QColor, QPolygonF>> stripes_;
  QPolygonF highlight_;
  std::optional<QPointF> place_;
  double zoom_ = 1.0;
  QPointF middle_;  // px, seen in the widget's middle
  QPixmap drawn_;   // image and stripes as they are seen now
  QPointF pressed_, last_;
};

// Copies pixels of CV_8UC3 (BGR); null for an empty image.
QImage ToQImage(const cv::Mat& image);

}  // namespace dorsum
