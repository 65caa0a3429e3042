// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>

#include "studio/job_runner.h"

namespace dorsum {

// A picture in the size in which it is painted. A camera's picture takes longer to scale than the window may
// wait: it is scaled beside it, and until then what was painted before stays.
class ScaledPicture : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void Set(QImage image);
  void Clear() { image_ = scaled_ = {}; }
  const QImage& image() const { return image_; }
  // The picture in this many pixels, or what there is before Ready(): another size, the picture before, null.
  const QImage& In(const QSize& pixels);

 signals:
  void Ready();  // In() has something better now

 private:
  QImage image_, scaled_;
  bool current_ = false;  // scaled_ is of image_
  JobRunner scaling_;
};

}  // namespace dorsum
