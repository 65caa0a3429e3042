// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "base/options.h"

class QUndoStack;

namespace dorsum {

// A row for each option of a table, made from the table alone: numbers with their range, switches, choices;
// the help as tooltip. What is set here is in the table's targets at once, and can be undone. The values at
// the time of making are the defaults.
class OptionPanel : public QWidget {
  Q_OBJECT

 public:
  // `table` must outlive the panel.
  explicit OptionPanel(OptionTable* table, QWidget* parent = nullptr);
  ~OptionPanel() override;

  QUndoStack* undo() { return undo_; }
  // What edits this option: a QSpinBox, QDoubleSpinBox, QCheckBox or QComboBox; none for an unknown name.
  QWidget* Editor(const std::string& name) const;
  bool IsDefault() const;
  // All options back to their defaults, as one step of the undo stack.
  void Reset();
  // What changes from now on is a step of its own; until then, changes of one option are one step.
  void EndStep() { ++step_; }

 signals:
  void Changed();  // the table holds other values than before

 private:
  class Change;
  struct Row {
    const OptionSpec* spec;
    QWidget* editor;
    std::string initial, value;  // as text
  };

  QWidget* MakeEditor(std::size_t row);
  void Edit(std::size_t row, const std::string& value);  // by the person
  void Apply(std::size_t row, const std::string& value);
  void Show(std::size_t row);

  OptionTable* table_;
  QUndoStack* undo_;
  std::vector<Row> rows_;
  int step_ = 0;
  bool showing_ = false;  // editors are being set to the table's values
};

}  // namespace dorsum
