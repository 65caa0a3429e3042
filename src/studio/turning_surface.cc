// SPDX-License-Identifier: Apache-2.0
#include "studio/turning_surface.h"

#include <QPainter>
#include <utility>

#include "report/mesh_picture.h"

namespace dorsum {
namespace {

constexpr int kViews = 24;     // once round
constexpr int kTurn_ms = 125;  // from view to view
const cv::Size kSize(640, 480);

}  // namespace

TurningSurface::TurningSurface(QWidget* parent) : QWidget(parent) {
  setObjectName("surface");
  setAccessibleName(tr("Surface"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  turn_.setInterval(kTurn_ms);
  connect(&turn_, &QTimer::timeout, this, [this] {
    if (views_.size() == kViews) shown_ = (shown_ + 1) % kViews;
    update();
  });
}

void TurningSurface::Show(std::shared_ptr<const Scan> scan) {
  scan_ = std::move(scan);
  views_.clear();
  shown_ = 0;
  turn_.stop();
  painting_.Cancel();
  if (!painting_.busy()) PaintNext();
  update();
}

void TurningSurface::PaintNext() {
  if (!scan_ || views_.size() == kViews) return;
  painting_.Run<std::pair<std::shared_ptr<const Scan>, QImage>>(
      "paint",
      [scan = scan_, number = views_.size()](
          const Context& context) -> Result<std::pair<std::shared_ptr<const Scan>, QImage>> {
        MeshView view = kFrontView;
        view.azimuth_deg += 360.0 * static_cast<double>(number) / kViews;
        MeshPictureOptions options;
        options.size = kSize;
        options.samples = 1;
        const cv::Mat bgr = RenderMesh(scan->surface.mesh, view, options, context);
        DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
        const QImage image(bgr.data, bgr.cols, bgr.rows, static_cast<qsizetype>(bgr.step),
                           QImage::Format_BGR888);
        return std::pair(scan, image.copy());
      },
      [this](Result<std::pair<std::shared_ptr<const Scan>, QImage>> painted) {
        if (painted.ok() && painted->first == scan_) {
          views_.push_back(painted->second);
          shown_ = views() - 1;
          update();
          if (views_.size() == 1) emit Drawn();
          if (views_.size() == kViews) turn_.start();
        }
        PaintNext();
      });
}

void TurningSurface::hideEvent(QHideEvent* event) {
  turn_.stop();
  QWidget::hideEvent(event);
}

void TurningSurface::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (views_.empty()) return;
  if (views_.size() == kViews && !turn_.isActive()) turn_.start();
  const QImage& image = views_[static_cast<std::size_t>(shown_)];
  const QSize size = image.size().scaled(this->size(), Qt::KeepAspectRatio);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRect(QPoint((width() - size.width()) / 2, (height() - size.height()) / 2), size), image);
}

TurningSurface* MakeSurfaceWidget(QWidget* parent) { return new TurningSurface(parent); }

}  // namespace dorsum
