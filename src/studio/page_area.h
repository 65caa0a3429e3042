// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>

namespace dorsum {

// Shows a page in the room that there is. A page that needs more, on a small screen or at 200 %, keeps the
// least size that it can be used in and is moved under the window; one that fits is never moved.
class PageArea : public QScrollArea {
  Q_OBJECT

 public:
  explicit PageArea(QWidget* page, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void Fit();
};

}  // namespace dorsum
