// SPDX-License-Identifier: Apache-2.0
#include "studio/fitted_picture.h"

#include <QPainter>
#include <memory>
#include <stdexcept>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace dorsum {

FittedPicture::FittedPicture(const QString& name, QWidget* parent) : QWidget(parent) {
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(&picture_, &ScaledPicture::Ready, this, [this] { update(); });
}

QImage FittedPicture::ImageOf(const cv::Mat& picture) {
  if (picture.empty()) return {};
  const bool grey = picture.type() == CV_8UC1;
  if (!grey && picture.type() != CV_8UC3) throw std::logic_error("a picture of 8-bit BGR or grey is wanted");
  auto kept = std::make_unique<cv::Mat>(picture);
  const uchar* pixels = picture.data;  // not to be written: an image that is painted on takes its own
  return {pixels,
          picture.cols,
          picture.rows,
          static_cast<qsizetype>(picture.step[0]),
          grey ? QImage::Format_Grayscale8 : QImage::Format_BGR888,
          [](void* mat) { delete static_cast<cv::Mat*>(mat); },
          kept.release()};
}

QImage FittedPicture::Scaled(const QImage& image, const QSize& size) {
  if (image.isNull() || size.isEmpty()) return {};
  const QImage bgr = image.convertToFormat(QImage::Format_BGR888);
  const cv::Mat from(bgr.height(), bgr.width(), CV_8UC3, const_cast<uchar*>(bgr.constBits()),
                     static_cast<std::size_t>(bgr.bytesPerLine()));
  QImage scaled(size, QImage::Format_BGR888);
  cv::Mat to(size.height(), size.width(), CV_8UC3, scaled.bits(),
             static_cast<std::size_t>(scaled.bytesPerLine()));
  cv::resize(from, to, to.size(), 0, 0, size.width() < image.width() ? cv::INTER_AREA : cv::INTER_LINEAR);
  return scaled.convertToFormat(QImage::Format_RGB32);  // what painters copy without a look at each pixel
}

void FittedPicture::Show(QImage image) {
  picture_.Set(std::move(image));
  update();
}

void FittedPicture::Clear(const QString& words) {
  picture_.Clear();
  words_ = words;
  update();
}

QSize FittedPicture::sizeHint() const {
  const int line = fontMetrics().height();
  return {32 * line, 24 * line};
}

QSize FittedPicture::minimumSizeHint() const {
  const int line = fontMetrics().height();
  return {12 * line, 9 * line};
}

void FittedPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (image().isNull()) {
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, words_);
    return;
  }
  const QSizeF size = QSizeF(image().size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  const QRectF place(QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size);
  const QImage& drawn = picture_.In((size * devicePixelRatioF()).toSize());
  if (drawn.isNull()) return;
  painter.drawImage(place, drawn);
  PaintOver(&painter, place);
}

}  // namespace dorsum
