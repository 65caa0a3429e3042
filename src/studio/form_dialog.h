// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <optional>
#include <string>

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace dorsum {

// Questions in rows, and a sentence on what is still wrong with the answers; it can only be accepted when
// there is none.
class FormDialog : public QDialog {
  Q_OBJECT

 public:
  QString problem() const;  // empty: the answers are fine

 protected:
  // `accept`: what the button says that does it.
  FormDialog(const QString& title, const QString& accept, QWidget* parent);

  // Names a field for people, programs and tests, and adds its row.
  void AddField(const QString& label, QWidget* field, const QString& name, const QString& help);
  // A line for a folder's path, with a button to choose it.
  QLineEdit* AddFolder(const QString& label, const QString& name, const QString& help);
  // To be called once when all fields are there, and whenever an answer changed.
  void Check();

 private:
  virtual QString FindProblem() const = 0;

  QFormLayout* form_;
  QLabel* problem_;
  QPushButton* accept_;
};

}  // namespace dorsum
