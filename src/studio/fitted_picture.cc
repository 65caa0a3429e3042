// SPDX-License-Identifier: Apache-2.0
#include "studio/fitted_picture.h"

#include <QPainter>
#include <stdexcept>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace dorsum {

FittedPicture::FittedPicture(const QString& name, QWidget* parent) : QWidget(parent) {
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QImage FittedPicture::ImageOf(const cv::Mat& picture) {
  if (picture.empty()) return {};
  const bool grey = picture.type() == CV_8UC1;
  if (!grey && picture.type() != CV_8UC3) throw std::logic_error("a picture of 8-bit BGR or grey is wanted");
  return QImage(picture.data, picture.cols, picture.rows, static_cast<qsizetype>(picture.step[0]),
                grey ? QImage::Format_Grayscale8 : QImage::Format_BGR888)
      .copy();
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
  image_ = std::move(image);
  drawn_ = {};
  update();
}

void FittedPicture::Clear(const QString& words) {
  image_ = drawn_ = {};
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
  if (image_.isNull()) {
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, words_);
    return;
  }
  const QSizeF size = QSizeF(image_.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  const QRectF place(QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size);
  const QSize pixels = (size * devicePixelRatioF()).toSize();
  if (drawn_.size() != pixels) drawn_ = Scaled(image_, pixels);
  painter.drawImage(place, drawn_);
  PaintOver(&painter, place);
}

}  // namespace dorsum
