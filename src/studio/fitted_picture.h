// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

#include <opencv2/core.hpp>

#include "studio/scaled_picture.h"

class QPainter;

namespace dorsum {

// A picture as large as it fits, in its own proportions; words where there is none.
class FittedPicture : public QWidget {
  Q_OBJECT

 public:
  explicit FittedPicture(const QString& name, QWidget* parent = nullptr);

  // An 8-bit picture, BGR or grey, whose pixels are shared: nobody may change them any more.
  static QImage ImageOf(const cv::Mat& picture);
  // The picture in exactly this size, ready to be painted: several times as fast as a painter scales it.
  static QImage Scaled(const QImage& image, const QSize& size);

  void Show(QImage image);
  void Clear(const QString& words);
  const QImage& image() const { return picture_.image(); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  // Over the picture, which fills `place`.
  virtual void PaintOver(QPainter* /*painter*/, const QRectF& /*place*/) {}

 private:
  ScaledPicture picture_;
  QString words_;
};

}  // namespace dorsum
