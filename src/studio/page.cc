// SPDX-License-Identifier: Apache-2.0
#include "studio/page.h"

namespace dorsum {

Page::Page(Workbench* workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {}

}  // namespace dorsum
