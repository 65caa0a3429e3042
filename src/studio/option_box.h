// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "studio/option_panel.h"

namespace dorsum {

// The rows of an option table, to be scrolled, and below them what takes changes back, makes them again and
// puts all back to the defaults.
class OptionBox : public QWidget {
  Q_OBJECT

 public:
  // `table` must outlive the box.
  OptionBox(OptionTable* table, const QString& title, QWidget* parent = nullptr);

  OptionPanel* panel() { return panel_; }

 private:
  OptionPanel* panel_;
};

}  // namespace dorsum
