// SPDX-License-Identifier: Apache-2.0
#include "studio/live_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "studio/fitted_picture.h"

namespace dorsum {

LiveView::LiveView(QWidget* parent) : QWidget(parent) {
  setObjectName("live");
  setAccessibleName(tr("Live picture"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(&picture_, &ScaledPicture::Ready, this, [this] { update(); });
}

void LiveView::Show(const HandView& view) {
  if (view.picture.empty()) {
    picture_.Clear();
  } else if (view.picture.data != view_.picture.data) {
    picture_.Set(FittedPicture::ImageOf(view.picture));
  }
  view_ = view;
  update();
}

void LiveView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Dark));
  const cv::Mat& bgr = view_.picture;
  if (bgr.empty()) return;
  const double scale =
      std::min(static_cast<double>(width()) / bgr.cols, static_cast<double>(height()) / bgr.rows);
  const QSizeF size(scale * bgr.cols, scale * bgr.rows);
  const QPointF corner((width() - size.width()) / 2.0, (height() - size.height()) / 2.0);
  const QImage& drawn = picture_.In((size * devicePixelRatioF()).toSize());
  if (drawn.isNull()) return;
  painter.drawImage(QRectF(corner, size), drawn);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(corner);
  painter.scale(scale, scale);
  // Pixels' centres lie at whole numbers in outlines, their corners in what is painted.
  painter.translate(0.5, 0.5);
  const bool good = view_.advice == Advice::kGood;
  QPen pen(good ? QColor(120, 255, 120) : QColor(255, 200, 60), good ? 4.0 : 3.0);
  pen.setCosmetic(true);
  painter.setPen(pen);
  for (const auto& outline : view_.outlines) {
    QPainterPath path;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const QPointF p(outline[i].x, outline[i].y);
      i == 0 ? path.moveTo(p) : path.lineTo(p);
    }
    path.closeSubpath();
    painter.drawPath(path);
  }
}

}  // namespace dorsum
