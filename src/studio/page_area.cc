// SPDX-License-Identifier: Apache-2.0
#include "studio/page_area.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <algorithm>

namespace dorsum {

// Not QScrollArea's own resizing: with words that wrap it takes the height that a page would like for the
// one that it needs.
PageArea::PageArea(QWidget* page, QWidget* parent) : QScrollArea(parent) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setWidget(page);
  page->installEventFilter(this);
}

void PageArea::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  Fit();
}

bool PageArea::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) Fit();
  return QScrollArea::eventFilter(watched, event);
}

void PageArea::Fit() {
  const QSize all = maximumViewportSize();
  QSize room = all, least = widget()->minimumSizeHint();
  const auto wrapped = [&] {
    const QLayout* layout = widget()->layout();
    const int width = std::max(room.width(), least.width());
    return layout != nullptr && layout->hasHeightForWidth()
               ? std::max(least.height(), layout->minimumHeightForWidth(width))
               : least.height();
  };
  // A bar takes room from the other direction.
  if (least.width() > room.width()) room.rheight() -= horizontalScrollBar()->sizeHint().height();
  if (wrapped() > room.height()) room.rwidth() -= verticalScrollBar()->sizeHint().width();
  if (least.width() > room.width()) room.setHeight(all.height() - horizontalScrollBar()->sizeHint().height());
  least.setHeight(wrapped());
  widget()->resize(room.expandedTo(least));
}

}  // namespace dorsum
