// SPDX-License-Identifier: Apache-2.0
#include "studio/form_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace dorsum {

FormDialog::FormDialog(const QString& title, const QString& accept, QWidget* parent)
    : QDialog(parent), form_(new QFormLayout), problem_(new QLabel(this)) {
  setWindowTitle(title);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  problem_->setObjectName("problem");
  problem_->setAccessibleName(tr("What is still to be done"));
  problem_->setWordWrap(true);
  problem_->setMinimumHeight(3 * problem_->fontMetrics().lineSpacing());  // so that the rows do not jump
  problem_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  accept_ = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
  accept_->setObjectName("accept");
  accept_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form_);
  column->addStretch(1);
  column->addWidget(problem_);
  column->addWidget(buttons);
  setMinimumWidth(fontMetrics().averageCharWidth() * 70);
}

QString FormDialog::problem() const { return problem_->text(); }

void FormDialog::AddField(const QString& label, QWidget* field, const QString& name, const QString& help) {
  field->setObjectName(name);
  field->setAccessibleName(QString(label).remove('&'));
  field->setToolTip("<p>" + help.toHtmlEscaped() + "</p>");
  form_->addRow(label, field);
}

QLineEdit* FormDialog::AddFolder(const QString& label, const QString& name, const QString& help) {
  auto* line = new QLineEdit(this);
  line->setObjectName(name);
  line->setAccessibleName(QString(label).remove('&'));
  line->setToolTip("<p>" + help.toHtmlEscaped() + "</p>");
  auto* choose = new QPushButton(tr("Choose…"), this);
  choose->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(line, 1);
  row->addWidget(choose);
  auto* title = new QLabel(label, this);
  title->setBuddy(line);
  form_->addRow(title, row);
  connect(choose, &QPushButton::clicked, this, [this, line, label] {
    const QString path = QFileDialog::getExistingDirectory(this, QString(label).remove('&'), line->text());
    if (!path.isEmpty()) line->setText(path);
  });
  connect(line, &QLineEdit::textChanged, this, &FormDialog::Check);
  return line;
}

void FormDialog::Check() {
  problem_->setText(FindProblem());
  accept_->setEnabled(problem_->text().isEmpty());
}

}  // namespace dorsum
