// SPDX-License-Identifier: Apache-2.0
#pragma once

class QTreeWidget;

namespace dorsum {

// Lets the rows of a table become as high as the words in them need at the widths that its columns have. Qt's
// own word wrap only wraps where a row is high enough already.
void WrapWords(QTreeWidget* tree);

}  // namespace dorsum
