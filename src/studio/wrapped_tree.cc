// SPDX-License-Identifier: Apache-2.0
#include "studio/wrapped_tree.h"

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTreeWidget>

namespace dorsum {
namespace {

class WrappingDelegate : public QStyledItemDelegate {
 public:
  explicit WrappingDelegate(QTreeWidget* tree) : QStyledItemDelegate(tree), tree_(tree) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem narrow = option;
    int width = tree_->columnWidth(index.column());
    if (index.column() == 0) {
      for (QModelIndex i = index; i.isValid(); i = i.parent()) width -= tree_->indentation();
    }
    narrow.rect = QRect(0, 0, width, option.fontMetrics.height());
    return QStyledItemDelegate::sizeHint(narrow, index);
  }

 private:
  QTreeWidget* tree_;
};

}  // namespace

void WrapWords(QTreeWidget* tree) {
  tree->setWordWrap(true);
  tree->setItemDelegate(new WrappingDelegate(tree));
  QObject::connect(tree->header(), &QHeaderView::sectionResized, tree, [tree] {
    QMetaObject::invokeMethod(tree, &QTreeWidget::doItemsLayout, Qt::QueuedConnection);
  });
}

}  // namespace dorsum
