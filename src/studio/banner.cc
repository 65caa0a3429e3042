// SPDX-License-Identifier: Apache-2.0
#include "studio/banner.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

#include "studio/library_words.h"

namespace dorsum {

Banner::Banner(QWidget* parent) : QFrame(parent), text_(new QLabel(this)) {
  setObjectName("banner");
  setFrameShape(QFrame::StyledPanel);
  auto* sign = new QLabel(this);
  const int side = style()->pixelMetric(QStyle::PM_SmallIconSize);
  sign->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(side, side));
  text_->setObjectName("bannerText");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setAccessibleName(tr("What went wrong"));
  auto* close = new QToolButton(this);
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setAccessibleName(tr("Close the message"));
  close->setShortcut(Qt::Key_Escape);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout(this);
  row->addWidget(sign);
  row->addWidget(text_, 1);
  row->addWidget(close);
  hide();
}

void Banner::Show(const Error& error) {
  QString sentence = InOwnWords(error.message);
  if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
  if (!sentence.endsWith('.')) sentence += '.';
  text_->setText(sentence);
  show();
  QAccessibleEvent event(text_, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

QString Banner::text() const { return isVisibleTo(parentWidget()) ? text_->text() : QString(); }

}  // namespace dorsum
