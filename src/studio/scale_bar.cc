// SPDX-License-Identifier: Apache-2.0
#include "studio/scale_bar.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace dorsum {
namespace {

QColor ToQColor(const Colour& c) { return {c[2], c[1], c[0]}; }

}  // namespace

std::vector<double> RoundNumbers(double low, double high, int count) {
  std::vector<double> numbers;
  if (!(high > low) || !std::isfinite(high - low) || count < 1) return numbers;
  const double rough = (high - low) / count, power = std::pow(10.0, std::floor(std::log10(rough)));
  const double ratio = rough / power;
  const double step = power * (ratio <= 1.0 ? 1.0 : ratio <= 2.0 ? 2.0 : ratio <= 5.0 ? 5.0 : 10.0);
  for (double n = std::ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; n += 1.0) {
    numbers.push_back(n * step);
  }
  return numbers;
}

QString NumberText(double number, double step) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return QLocale().toString(std::abs(number) < 1e-9 ? 0.0 : number, 'f', digits);
}

ScaleBar::ScaleBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize ScaleBar::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 30, fontMetrics().height() * 2 + 4};
}

void ScaleBar::SetScale(const ColourScale& scale) {
  scale_ = scale;
  QString text;
  if (!scale.classes.empty()) {
    for (const auto& [number, colour] : scale.classes) text += QString::number(number) + ' ';
  } else if (scale.by != ColourBy::kShaded) {
    text = tr("%1 to %2 mm").arg(scale.low, 0, 'g', 3).arg(scale.high, 0, 'g', 3);
  }
  setAccessibleDescription(text);
  update();
}

void ScaleBar::paintEvent(QPaintEvent*) {
  if (scale_.by == ColourBy::kShaded) return;
  QPainter painter(this);
  const int line = fontMetrics().height(), unit = fontMetrics().horizontalAdvance("0");
  painter.setPen(palette().color(QPalette::WindowText));
  if (!scale_.classes.empty()) {
    const double each = std::min<double>(width() / static_cast<double>(scale_.classes.size()), 6.0 * unit);
    // Where numbers would touch, every second or third is written.
    const int skip = std::max(1, static_cast<int>(std::ceil(4.0 * unit / each)));
    int i = 0;
    for (const auto& [number, colour] : scale_.classes) {
      const QRectF box(i * each, 0.0, each - 1.0, line);
      painter.fillRect(box, ToQColor(colour));
      if (i % skip == 0) {
        painter.drawText(QRectF(box.center().x() - 4.0 * unit, line + 2.0, 8.0 * unit, line),
                         Qt::AlignHCenter | Qt::AlignTop, QString::number(number));
      }
      ++i;
    }
    return;
  }
  const double left = 4.0 * unit, right = width() - 8.0 * unit, span = std::max(right - left, 1.0);
  const int steps = static_cast<int>(span);
  for (int x = 0; x < steps; ++x) {
    const double value = scale_.low + (scale_.high - scale_.low) * x / std::max(steps - 1, 1);
    painter.fillRect(QRectF(left + x, 0.0, 1.5, line), ToQColor(scale_.At(value)));
  }
  const std::vector<double> numbers =
      RoundNumbers(scale_.low, scale_.high, std::max(2, static_cast<int>(span / (10.0 * unit))));
  const double step = numbers.size() > 1 ? numbers[1] - numbers[0] : scale_.high - scale_.low;
  for (const double n : numbers) {
    const double x = left + span * (n - scale_.low) / (scale_.high - scale_.low);
    painter.drawLine(QPointF(x, line), QPointF(x, line + 3.0));
    painter.drawText(QRectF(x - 5.0 * unit, line + 3.0, 10.0 * unit, line), Qt::AlignHCenter | Qt::AlignTop,
                     NumberText(n, step));
  }
  painter.drawText(QRectF(right + unit, 0.0, 7.0 * unit, line), Qt::AlignLeft | Qt::AlignVCenter, tr("mm"));
}

}  // namespace dorsum
