// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "base/result.h"

class QLabel;

namespace dorsum {

// What went wrong, in a sentence, above the page until the person closes it or something else goes wrong.
class Banner : public QFrame {
  Q_OBJECT

 public:
  explicit Banner(QWidget* parent = nullptr);
  void Show(const Error& error);
  QString text() const;

 private:
  QLabel* text_;
};

}  // namespace dorsum
