// SPDX-License-Identifier: Apache-2.0
#include "studio/coverage_view.h"

#include <QPainter>
#include <QPixmap>
#include <cmath>
#include <utility>

namespace dorsum {
namespace {

// A series has thousands of corners: one dot is painted, and copied to all.
QPixmap Dot(double radius, const QColor& colour, double ratio) {
  const int side = 2 * static_cast<int>(std::ceil(radius)) + 1;
  QPixmap dot((QSizeF(side, side) * ratio).toSize());
  dot.setDevicePixelRatio(ratio);
  dot.fill(Qt::transparent);
  QPainter painter(&dot);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawEllipse(QPointF(0.5 * side, 0.5 * side), radius, radius);
  return dot;
}

}  // namespace

void CoverageView::SetBoards(std::optional<BoardCoverage> coverage,
                             std::vector<std::vector<cv::Point2f>> boards) {
  coverage_ = std::move(coverage);
  boards_ = std::move(boards);
  update();
}

void CoverageView::ShowGrid(bool shown) {
  grid_ = shown;
  update();
}

void CoverageView::PaintOver(QPainter* painter, const QRectF& place) {
  if (!grid_ || !coverage_ || image().isNull()) return;
  QColor tint = palette().color(QPalette::Highlight), line = tint;
  tint.setAlphaF(0.25F);
  line.setAlphaF(0.6F);
  const double width = place.width() / BoardCoverage::kColumns,
               height = place.height() / BoardCoverage::kRows;
  painter->setPen(QPen(line, 1.0));
  for (int row = 0; row < BoardCoverage::kRows; ++row) {
    for (int column = 0; column < BoardCoverage::kColumns; ++column) {
      const QRectF cell(place.x() + column * width, place.y() + row * height, width, height);
      painter->setBrush(coverage_->Covers(column, row) ? QBrush(tint) : QBrush(Qt::NoBrush));
      painter->drawRect(cell);
    }
  }
  const double scale = place.width() / image().width();
  const double dot = fontMetrics().height() / 12.0;
  const QPixmap small = Dot(dot, line, devicePixelRatioF()),
                large = Dot(2.0 * dot, palette().color(QPalette::Highlight), devicePixelRatioF());
  for (std::size_t i = 0; i < boards_.size(); ++i) {
    const QPixmap& copied = i + 1 == boards_.size() ? large : small;
    const double half = 0.5 * copied.deviceIndependentSize().width();
    const QPointF corner = place.topLeft() - QPointF(half, half);
    for (const cv::Point2f& p : boards_[i]) painter->drawPixmap(corner + QPointF(p.x, p.y) * scale, copied);
  }
}

}  // namespace dorsum
