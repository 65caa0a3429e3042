// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "studio/workbench.h"

namespace dorsum {

// One page of the window. All that it knows of the others goes through the workbench.
class Page : public QWidget {
  Q_OBJECT

 public:
  Page(Workbench* workbench, QWidget* parent);

  virtual void Enter() {}  // it is now what the person sees
  virtual void Leave() {}  // it is not any more: stop the preview, switch lights off

 protected:
  Workbench* workbench() const { return workbench_; }

 private:
  Workbench* workbench_;
};

}  // namespace dorsum
