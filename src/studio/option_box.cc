// SPDX-License-Identifier: Apache-2.0
#include "studio/option_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QUndoStack>
#include <QVBoxLayout>

namespace dorsum {

OptionBox::OptionBox(OptionTable* table, const QString& title, QWidget* parent)
    : QWidget(parent), panel_(new OptionPanel(table)) {
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(panel_);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(panel_->minimumSizeHint().width() +
                          scroll->verticalScrollBar()->sizeHint().width());
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const char* name, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setEnabled(false);
    row->addWidget(button);
    return button;
  };
  QUndoStack* stack = panel_->undo();
  auto* undo = add(tr("&Undo"), "undo", tr("Takes the last change of a parameter back (Ctrl+Z)"));
  auto* redo = add(tr("&Redo"), "redo", tr("Makes the change again (Ctrl+Shift+Z)"));
  auto* reset = add(tr("R&eset"), "reset", tr("Puts all parameters back to their defaults; can be undone"));
  // Not the buttons' own shortcuts: those wait until the button was seen to be pressed.
  new QShortcut(QKeySequence::Undo, this, [stack] { stack->undo(); });
  new QShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), this, [stack] { stack->redo(); });
  connect(undo, &QPushButton::clicked, stack, &QUndoStack::undo);
  connect(redo, &QPushButton::clicked, stack, &QUndoStack::redo);
  connect(reset, &QPushButton::clicked, panel_, &OptionPanel::Reset);
  connect(stack, &QUndoStack::canUndoChanged, undo, &QWidget::setEnabled);
  connect(stack, &QUndoStack::canRedoChanged, redo, &QWidget::setEnabled);
  connect(stack, &QUndoStack::indexChanged, reset,
          [this, reset] { reset->setEnabled(!panel_->IsDefault()); });
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel("<b>" + title + "</b>", this));
  column->addWidget(scroll, 1);
  column->addLayout(row);
}

}  // namespace dorsum
