// SPDX-License-Identifier: Apache-2.0
#include "studio/image_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "report/colours.h"

namespace dorsum {
namespace {

constexpr double kAim_px = 8.0;    // of the widget
constexpr double kGap_px = 4.0;    // of the image: a stripe with a wider hole is drawn with one
const QColor kMark(255, 20, 190);  // as in the view of the surface

}  // namespace

QImage ToQImage(const cv::Mat& image) {
  if (image.empty() || image.type() != CV_8UC3) return {};
  return QImage(image.data, image.cols, image.rows, static_cast<qsizetype>(image.step), QImage::Format_BGR888)
      .copy();
}

ImageView::ImageView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(fontMetrics().averageCharWidth() * 20, fontMetrics().height() * 6);
}

QSize ImageView::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 50, fontMetrics().height() * 16};
}

void ImageView::SetImage(const QImage& image) {
  image_ = image;
  if (!image_.isNull() && size_ != QSizeF(image_.size())) {
    size_ = image_.size();
    zoom_ = 1.0;
    middle_ = {0.5 * size_.width(), 0.5 * size_.height()};
  }
  Redraw();
}

void ImageView::SetStripes(const SurfacePoints& points, std::optional<int> laser) {
  std::map<std::tuple<int, int, int>, QPolygonF> found;
  double right = 1.0, bottom = 1.0;
  for (const SurfacePoint& p : points) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v) || (laser && p.laser != *laser)) continue;
    found[{p.laser, p.order, p.segment}].append(QPointF(p.u, p.v));
    right = std::max(right, p.u + 1.0);
    bottom = std::max(bottom, p.v + 1.0);
  }
  stripes_.clear();
  for (auto& [key, stripe] : found) {
    std::stable_sort(stripe.begin(), stripe.end(),
                     [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    const Colour c = OrderColour(std::get<1>(key));
    QPolygonF run;
    for (const QPointF& p : stripe) {
      if (!run.isEmpty() && QLineF(run.back(), p).length() > kGap_px) {
        stripes_.emplace_back(QColor(c[2], c[1], c[0]), run);
        run.clear();
      }
      run.append(p);
    }
    stripes_.emplace_back(QColor(c[2], c[1], c[0]), run);
  }
  if (image_.isNull()) {
    size_ = QSizeF(right, bottom) * 1.04;  // the image was a little larger than what was found in it
    zoom_ = 1.0;
    middle_ = {0.5 * size_.width(), 0.5 * size_.height()};
  }
  Redraw();
}

void ImageView::SetHighlight(const QPolygonF& stripe, std::optional<QPointF> place) {
  highlight_ = stripe;
  place_ = place;
  update();
}

double ImageView::Scale() const {
  if (size_.isEmpty()) return 1.0;
  return zoom_ * std::min(width() / size_.width(), height() / size_.height());
}

// Pixel centres are at integer coordinates.
QPointF ImageView::ToWidget(const QPointF& image) const {
  return (image + QPointF(0.5, 0.5) - middle_) * Scale() + QRectF(rect()).center();
}
QPointF ImageView::ToImage(const QPointF& widget) const {
  return (widget - QRectF(rect()).center()) / Scale() + middle_ - QPointF(0.5, 0.5);
}

void ImageView::ZoomAt(const QPointF& widget, double factor) {
  const QPointF before = ToImage(widget);
  zoom_ = std::clamp(zoom_ * factor, 1.0, 60.0);
  middle_ += before - ToImage(widget);
  if (zoom_ == 1.0) middle_ = {0.5 * size_.width(), 0.5 * size_.height()};
  Redraw();
}

void ImageView::Redraw() {
  drawn_ = {};
  update();
}

void ImageView::paintEvent(QPaintEvent*) {
  if (drawn_.isNull()) {
    drawn_ = QPixmap(size() * devicePixelRatioF());
    drawn_.setDevicePixelRatio(devicePixelRatioF());
    drawn_.fill(Qt::black);  // as a photo in the dark, which the colours of orders are made for
    QPainter painter(&drawn_);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!image_.isNull()) {
      painter.drawImage(QRectF(ToWidget({-0.5, -0.5}), QSizeF(image_.size()) * Scale()), image_);
    }
    for (const auto& [colour, stripe] : stripes_) {
      painter.setPen(QPen(colour, 1.2));
      QPolygonF seen;
      for (const QPointF& p : stripe) seen.append(ToWidget(p));
      painter.drawPolyline(seen);
    }
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, drawn_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(kMark, 2.5));
  QPolygonF seen;
  for (const QPointF& p : highlight_) seen.append(ToWidget(p));
  painter.drawPolyline(seen);
  if (place_) painter.drawEllipse(ToWidget(*place_), 6.0, 6.0);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void ImageView::resizeEvent(QResizeEvent*) { Redraw(); }
void ImageView::mousePressEvent(QMouseEvent* event) { pressed_ = last_ = event->position(); }

void ImageView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return;
  middle_ -= (event->position() - last_) / Scale();
  last_ = event->position();
  Redraw();
}

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
  if ((event->position() - pressed_).manhattanLength() >= 4.0) return;
  emit Aimed(ToImage(event->position()), kAim_px / Scale());
}

void ImageView::wheelEvent(QWheelEvent* event) {
  ZoomAt(event->position(), std::pow(1.0015, event->angleDelta().y()));
}

void ImageView::keyPressEvent(QKeyEvent* event) {
  const QPointF here = QRectF(rect()).center();
  const double step = 0.1 * width() / Scale();
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return ZoomAt(here, 1.25);
    case Qt::Key_Minus:
      return ZoomAt(here, 0.8);
    case Qt::Key_Home:
      return ZoomAt(here, 1e-9);
    case Qt::Key_Left:
      middle_.rx() -= step;
      return Redraw();
    case Qt::Key_Right:
      middle_.rx() += step;
      return Redraw();
    case Qt::Key_Up:
      middle_.ry() -= step;
      return Redraw();
    case Qt::Key_Down:
      middle_.ry() += step;
      return Redraw();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      emit Aimed(ToImage(here), kAim_px / Scale());
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace dorsum
