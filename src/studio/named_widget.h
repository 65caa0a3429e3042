// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace dorsum {

// Gives a widget its names, for tests and style sheets and for who does not see it, and its tooltip.
template <class T>
T* Named(T* widget, const char* object, const QString& name, const QString& help) {
  widget->setObjectName(object);
  widget->setAccessibleName(name);
  widget->setToolTip(help);
  return widget;
}

}  // namespace dorsum
