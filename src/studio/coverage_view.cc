// SPDX-License-Identifier: Apache-2.0
#include "studio/coverage_view.h"

#include <QPainter>
#include <utility>

namespace dorsum {

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
  painter->setRenderHint(QPainter::Antialiasing);
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
  painter->setPen(Qt::NoPen);
  for (std::size_t i = 0; i < boards_.size(); ++i) {
    const bool last = i + 1 == boards_.size();
    painter->setBrush(last ? palette().color(QPalette::Highlight) : line);
    for (const cv::Point2f& p : boards_[i]) {
      const double radius = last ? 2.0 * dot : dot;
      painter->drawEllipse(place.topLeft() + QPointF(p.x * scale, p.y * scale), radius, radius);
    }
  }
}

}  // namespace dorsum
