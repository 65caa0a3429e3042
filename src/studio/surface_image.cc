// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_image.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "studio/image_view.h"
#include "studio/named_widget.h"

namespace dorsum {

SurfaceImage::SurfaceImage(QWidget* parent)
    : QWidget(parent), image_(new ImageView(this)), images_(new QComboBox(this)) {
  Named(image_, "imageView", tr("Image"),
        tr("The image with its stripes; a click or Enter picks a stripe, the wheel, + and - zoom, Home shows "
           "all"));
  Named(images_, "images", tr("Image that is shown"), tr("Which of the capture's images, and whose stripes"));
  auto* label = new QLabel(tr("&Image:"), this);
  label->setBuddy(images_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(images_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(image_, 1);
  connect(images_, &QComboBox::currentIndexChanged, this, &SurfaceImage::ShowImage);
  connect(image_, &ImageView::Aimed, this, &SurfaceImage::AimedAt);
}

std::optional<int> SurfaceImage::laser() const {
  const int value = images_->currentData().toInt();
  return images_->currentIndex() < 0 || value < 0 ? std::nullopt : std::optional<int>(value);
}

void SurfaceImage::SetScan(std::shared_ptr<const Scan> scan) {
  scan_ = std::move(scan);
  const bool leds = scan_ && !scan_->capture.hand.empty();
  {
    const QSignalBlocker quiet(images_);
    images_->clear();
    images_->addItem(scan_ && !leds ? tr("All stripes") : tr("LEDs, all stripes"), -1);
    for (int k = 0; scan_ && k < static_cast<int>(scan_->capture.stripes.size()); ++k) {
      if (scan_->capture.stripes[static_cast<std::size_t>(k)]) images_->addItem(tr("Laser %1").arg(k), k);
    }
  }
  setVisible(leds || (scan_ && !scan_->surface.points.empty()));
  ShowImage();
}

void SurfaceImage::ShowImage() {
  cv::Mat shown_image;
  if (scan_) {
    const std::optional<int> k = laser();
    shown_image = k ? *scan_->capture.stripes[static_cast<std::size_t>(*k)] : scan_->capture.hand;
  }
  image_->SetImage(ToQImage(shown_image));
  image_->SetStripes(scan_ ? scan_->surface.points : SurfacePoints(), laser());
}

void SurfaceImage::ShowLaserOf(const SurfacePoint& point) {
  const int now = images_->findData(static_cast<int>(point.laser));
  if (laser() && now >= 0) images_->setCurrentIndex(now);
}

void SurfaceImage::Highlight(const SurfaceMeasurer& measured) {
  QPolygonF stripe;
  for (const std::uint32_t i : measured.stripe()) {
    stripe.append(QPointF(scan_->surface.points[i].u, scan_->surface.points[i].v));
  }
  std::optional<QPointF> place;
  if (!measured.places().empty() && measured.places().back().image) {
    const Eigen::Vector2d& at = *measured.places().back().image;
    place = QPointF(at.x(), at.y());
  }
  image_->SetHighlight(stripe, place);
}

void SurfaceImage::AimedAt(const QPointF& pixel, double reach_px) {
  if (!scan_) return;
  const auto point = PickInImage(scan_->surface.points, {pixel.x(), pixel.y()}, laser(), reach_px);
  if (!point) return;
  const SurfacePoint& p = scan_->surface.points[*point];
  // From above, so that a measure knows the face of the mesh there.
  std::optional<Picked> picked;
  if (!scan_->surface.mesh.faces.empty()) {
    picked = Pick(*scan_, {p.position + Eigen::Vector3d(0, 0, 1000.0), {0, 0, -1}}, Shown::kMesh, 0.0);
  }
  if (!picked) picked.emplace();
  picked->position = p.position;
  picked->point = *point;
  picked->image = Eigen::Vector2d(p.u, p.v);
  emit Aimed(*picked);
}

}  // namespace dorsum
