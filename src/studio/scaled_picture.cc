// SPDX-License-Identifier: Apache-2.0
#include "studio/scaled_picture.h"

#include <utility>

#include "studio/fitted_picture.h"

namespace dorsum {
namespace {

constexpr int kSmall_px = 500'000;  // scaled at once: takes no longer than to hand it over

}  // namespace

void ScaledPicture::Set(QImage image) {
  image_ = std::move(image);
  current_ = false;
}

const QImage& ScaledPicture::In(const QSize& pixels) {
  if (image_.isNull() || pixels.isEmpty() || (current_ && scaled_.size() == pixels)) return scaled_;
  if (image_.width() * image_.height() <= kSmall_px) {
    scaled_ = FittedPicture::Scaled(image_, pixels);
    current_ = true;
  } else if (!scaling_.busy()) {
    scaling_.Run<QImage>(
        {},
        [image = image_, pixels](const Context&) -> Result<QImage> {
          return FittedPicture::Scaled(image, pixels);
        },
        [this, key = image_.cacheKey()](Result<QImage> scaled) {
          if (image_.isNull()) return;  // cleared meanwhile
          scaled_ = std::move(scaled).value();
          current_ = key == image_.cacheKey();
          emit Ready();
        });
  }
  return scaled_;
}

}  // namespace dorsum
