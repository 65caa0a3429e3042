// SPDX-License-Identifier: Apache-2.0
#include "studio/picture_view.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "studio/fitted_picture.h"

namespace dorsum {
namespace {

constexpr double kMaxZoom = 64.0;
constexpr double kStep = 1.25;  // of the zoom, for a key or a notch of the wheel

}  // namespace

PictureView::PictureView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::OpenHandCursor);
}

QSize PictureView::sizeHint() const {
  const int em = fontMetrics().height();
  return {20 * em, 16 * em};
}

void PictureView::SetPicture(const cv::Mat& picture, const QString& words) {
  image_ = FittedPicture::ImageOf(picture).convertToFormat(QImage::Format_RGB32);  // what is drawn fastest
  smaller_.clear();
  cv::Mat half = picture;
  while (std::min(half.cols, half.rows) > 256) {
    cv::Mat next;
    cv::resize(half, next, {}, 0.5, 0.5, cv::INTER_AREA);
    half = next;
    smaller_.push_back(FittedPicture::ImageOf(half).convertToFormat(QImage::Format_RGB32));
  }
  words_ = words;
  setAccessibleDescription(image_.isNull() ? words : QString());
  update();
}

void PictureView::SetLook(const Look& look) {
  Look kept = look;
  kept.zoom = std::clamp(kept.zoom, 1.0, kMaxZoom);
  kept.centre = {std::clamp(kept.centre.x(), 0.0, 1.0), std::clamp(kept.centre.y(), 0.0, 1.0)};
  if (kept.zoom == 1.0) kept.centre = {0.5, 0.5};
  if (kept == look_) return;
  look_ = kept;
  update();
  emit Looked(look_);
}

void PictureView::Link(PictureView* one, PictureView* other) {
  connect(one, &PictureView::Looked, other, &PictureView::SetLook);
  connect(other, &PictureView::Looked, one, &PictureView::SetLook);
}

double PictureView::Scale() const {
  if (image_.isNull()) return 1.0;
  return look_.zoom * std::min(width() / double(image_.width()), height() / double(image_.height()));
}

void PictureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (image_.isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const int margin = fontMetrics().height();
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                     words_);
  } else {
    const double scale = Scale();
    const QPointF corner =
        QRectF(rect()).center() -
        QPointF(look_.centre.x() * image_.width(), look_.centre.y() * image_.height()) * scale;
    // Only what is seen: a large picture that is zoomed in costs no more than a small one.
    const QRectF wanted =
        QRectF(rect()).intersected(QRectF(corner, QSizeF(image_.width() * scale, image_.height() * scale)));
    const QRectF source((wanted.topLeft() - corner) / scale, wanted.size() / scale);
    // Thin stripes would break up in a picture of which only some pixels are taken.
    const QImage* drawn = &image_;
    for (const QImage& smaller : smaller_) {
      if (smaller.width() < image_.width() * scale * devicePixelRatioF()) break;
      drawn = &smaller;
    }
    const double across = drawn->width() / double(image_.width()),
                 down = drawn->height() / double(image_.height());
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale * devicePixelRatioF() < 2.0);
    painter.drawImage(
        wanted, *drawn,
        QRectF(source.x() * across, source.y() * down, source.width() * across, source.height() * down));
  }
  if (hasFocus()) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void PictureView::Zoom(double factor, QPointF fixed) {
  const double before = Scale();
  const double zoom = std::clamp(look_.zoom * factor, 1.0, kMaxZoom);
  if (image_.isNull() || zoom == look_.zoom) return;
  const QPointF off = fixed - QRectF(rect()).center();
  const double share = 1.0 / before - look_.zoom / (before * zoom);
  SetLook(
      {look_.centre + QPointF(off.x() * share / image_.width(), off.y() * share / image_.height()), zoom});
}

void PictureView::Move(QPointF by) {
  if (image_.isNull()) return;
  const double scale = Scale();
  SetLook({look_.centre - QPointF(by.x() / (scale * image_.width()), by.y() / (scale * image_.height())),
           look_.zoom});
}

void PictureView::wheelEvent(QWheelEvent* event) {
  Zoom(std::pow(kStep, event->angleDelta().y() / 120.0), event->position());
  event->accept();
}

void PictureView::mousePressEvent(QMouseEvent* event) { grabbed_ = event->position(); }

void PictureView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0) return;
  Move(event->position() - grabbed_);
  grabbed_ = event->position();
}

void PictureView::mouseDoubleClickEvent(QMouseEvent*) { SetLook({}); }

void PictureView::keyPressEvent(QKeyEvent* event) {
  const QPointF middle = QRectF(rect()).center();
  const double step = fontMetrics().height() * 2.0;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return Zoom(kStep, middle);
    case Qt::Key_Minus:
      return Zoom(1.0 / kStep, middle);
    case Qt::Key_0:
      return SetLook({});
    case Qt::Key_Left:
      return Move({step, 0});
    case Qt::Key_Right:
      return Move({-step, 0});
    case Qt::Key_Up:
      return Move({0, step});
    case Qt::Key_Down:
      return Move({0, -step});
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace dorsum
