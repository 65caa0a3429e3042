// SPDX-License-Identifier: Apache-2.0
#include "studio/section_plot.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <limits>

#include "studio/scale_bar.h"

namespace dorsum {

SectionPlot::SectionPlot(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(fontMetrics().averageCharWidth() * 20, fontMetrics().height() * 6);
}

QSize SectionPlot::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 50, fontMetrics().height() * 10};
}

void SectionPlot::SetSection(const Section& section) {
  section_ = section;
  pointed_.reset();
  const double far = std::numeric_limits<double>::infinity();
  low_ = {0.0, far};
  high_ = {std::max(section.length_mm, 1.0), -far};
  const auto take = [&](const Eigen::Vector2d& p) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  };
  for (const SectionCurve& curve : section.curves) {
    for (const Eigen::Vector2d& p : curve) take(p);
  }
  for (const Eigen::Vector2d& p : section.dots) take(p);
  if (!(high_.y() >= low_.y())) low_.y() = high_.y() = 0.0;
  const double room = std::max(0.08 * (high_.y() - low_.y()), 0.5);
  low_.y() -= room;
  high_.y() += room;
  update();
}

QRectF SectionPlot::Frame() const {
  const double unit = fontMetrics().horizontalAdvance("0"), line = fontMetrics().height();
  return QRectF(rect()).adjusted(6.0 * unit, 1.2 * line, -2.0 * unit, -2.4 * line);
}

QPointF SectionPlot::At(const Eigen::Vector2d& p) const {
  const QRectF frame = Frame();
  return {frame.left() + frame.width() * (p.x() - low_.x()) / (high_.x() - low_.x()),
          frame.bottom() - frame.height() * (p.y() - low_.y()) / (high_.y() - low_.y())};
}

void SectionPlot::PaintAxes(QPainter* painter) const {
  const QRectF frame = Frame();
  const double unit = fontMetrics().horizontalAdvance("0"), line = fontMetrics().height();
  QColor faint = palette().color(QPalette::Text);
  faint.setAlphaF(0.2F);
  for (const bool along : {true, false}) {
    const int axis = along ? 0 : 1;
    const double room = along ? frame.width() / (9.0 * unit) : frame.height() / (2.5 * line);
    const std::vector<double> numbers =
        RoundNumbers(low_[axis], high_[axis], std::max(2, static_cast<int>(room)));
    const double step = numbers.size() > 1 ? numbers[1] - numbers[0] : 1.0;
    for (const double n : numbers) {
      const QPointF at = At(along ? Eigen::Vector2d(n, low_.y()) : Eigen::Vector2d(low_.x(), n));
      painter->setPen(faint);
      painter->drawLine(at, along ? QPointF(at.x(), frame.top()) : QPointF(frame.right(), at.y()));
      painter->setPen(palette().color(QPalette::Text));
      const QRectF box = along ? QRectF(at.x() - 5.0 * unit, at.y() + 2.0, 10.0 * unit, line)
                               : QRectF(0.0, at.y() - 0.5 * line, frame.left() - 0.5 * unit, line);
      painter->drawText(box, along ? Qt::AlignHCenter : Qt::AlignRight | Qt::AlignVCenter,
                        NumberText(n, step));
    }
  }
  painter->drawText(QRectF(frame.left(), height() - 1.2 * line, frame.width(), line), Qt::AlignHCenter,
                    tr("along the line, mm"));
  QString title = tr("height, mm");
  if (pointed_) {
    title = tr("%1 mm along, %2 mm high").arg(pointed_->x(), 0, 'f', 2).arg(pointed_->y(), 0, 'f', 2);
  }
  painter->drawText(QRectF(0.5 * unit, 0.0, width() - unit, 1.1 * line), Qt::AlignLeft | Qt::AlignVCenter,
                    title);
}

void SectionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.setRenderHint(QPainter::Antialiasing);
  if (section_.curves.empty() && section_.dots.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(6, 6, -6, -6), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Choose Section and two places of the surface: the cut through them is drawn here."));
    return;
  }
  PaintAxes(&painter);
  const QRectF frame = Frame();
  painter.setPen(QPen(QColor(255, 20, 190), 1.0, Qt::DashLine));  // the places, as in the view
  for (const double s : {0.0, section_.length_mm}) {
    const double x = At({s, low_.y()}).x();
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
  }
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const SectionCurve& curve : section_.curves) {
    QPolygonF seen;
    for (const Eigen::Vector2d& p : curve) seen.append(At(p));
    painter.drawPolyline(seen);
  }
  painter.setPen(QPen(palette().color(QPalette::Highlight), 3.0, Qt::SolidLine, Qt::RoundCap));
  for (const Eigen::Vector2d& p : section_.dots) painter.drawPoint(At(p));
  if (pointed_) {
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.drawEllipse(At(*pointed_), 4.0, 4.0);
  }
}

void SectionPlot::mouseMoveEvent(QMouseEvent* event) {
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Eigen::Vector2d& p) {
    const double d = std::abs(At(p).x() - event->position().x());
    if (!(d < least)) return;
    least = d;
    pointed_ = p;
  };
  for (const SectionCurve& curve : section_.curves) {
    for (const Eigen::Vector2d& p : curve) offer(p);
  }
  for (const Eigen::Vector2d& p : section_.dots) offer(p);
  update();
}

void SectionPlot::leaveEvent(QEvent*) {
  pointed_.reset();
  update();
}

}  // namespace dorsum
