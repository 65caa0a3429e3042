// SPDX-License-Identifier: Apache-2.0
#include "studio/option_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QUndoStack>
#include <cmath>
#include <utility>

#include "studio/library_words.h"

namespace dorsum {
namespace {

// Turning the wheel over a panel scrolls it; it must not change the value that happens to lie below. And a
// box keeps the keys of undo to itself only while something typed in it is not finished.
class EditorGuard : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr) return false;
    const bool stray_wheel = event->type() == QEvent::Wheel && !widget->hasFocus();
    if (!stray_wheel && !AsksForUndo(*widget, event)) return false;
    event->ignore();
    return true;
  }

 private:
  static bool AsksForUndo(const QWidget& widget, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
    const auto* text = widget.findChild<QLineEdit*>();
    return text == nullptr || !text->isUndoAvailable();
  }
};

// Enough digits after the point for the default and for steps that matter in this range.
int Decimals(double value, double max) {
  int digits = max <= 10.0 ? 2 : 1;
  while (digits < 6 &&
         std::abs(value * std::pow(10.0, digits) - std::round(value * std::pow(10.0, digits))) > 1e-6)
    ++digits;
  return digits;
}

// A hundredth of the range, rounded down to a power of ten, but no less than the last digit shown.
double Step(const OptionSpec& spec, int decimals) {
  const double share = std::pow(10.0, std::floor(std::log10((spec.max - spec.min) / 100.0)));
  return std::max(share, std::pow(10.0, -decimals));
}

}  // namespace

class OptionPanel::Change : public QUndoCommand {
 public:
  Change(OptionPanel* panel, std::size_t row, std::string after, QUndoCommand* parent = nullptr)
      : QUndoCommand(parent),
        panel_(panel),
        row_(row),
        step_(panel->step_),
        before_(panel->rows_[row].value),
        after_(std::move(after)) {
    setText(QString::fromStdString(panel->rows_[row].spec->name));
  }
  void redo() override { panel_->Apply(row_, after_); }
  void undo() override { panel_->Apply(row_, before_); }
  int id() const override { return static_cast<int>(row_); }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const Change*>(other);
    if (next->step_ != step_) return false;
    after_ = next->after_;
    setObsolete(after_ == before_);
    return true;
  }

 private:
  OptionPanel* panel_;
  std::size_t row_;
  int step_;
  std::string before_, after_;
};

OptionPanel::OptionPanel(OptionTable* table, QWidget* parent)
    : QWidget(parent), table_(table), undo_(new QUndoStack(this)) {
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* guard = new EditorGuard(this);
  const std::vector<OptionSpec>& specs = table->specs();
  for (const OptionSpec& spec : specs) {
    const std::string value = OptionTable::ValueText(spec);
    rows_.push_back({&spec, nullptr, value, value});
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const QString name = QString::fromStdString(rows_[i].spec->name);
    const QString help = InOwnWords(rows_[i].spec->help);
    QWidget* editor = rows_[i].editor = MakeEditor(i);
    editor->setObjectName(name);
    editor->setAccessibleName(name);
    editor->setAccessibleDescription(help);
    editor->setToolTip("<p>" + help.toHtmlEscaped() + "</p>");
    editor->setFocusPolicy(Qt::StrongFocus);
    editor->installEventFilter(guard);
    auto* label = new QLabel(name, this);
    label->setBuddy(editor);
    label->setToolTip(editor->toolTip());
    form->addRow(label, editor);
    Show(i);
  }
}

QWidget* OptionPanel::MakeEditor(std::size_t row) {
  const OptionSpec& spec = *rows_[row].spec;
  if (auto* const* number = std::get_if<double*>(&spec.target)) {
    auto* box = new QDoubleSpinBox(this);
    const int decimals = Decimals(**number, spec.max);
    box->setDecimals(decimals);
    box->setRange(spec.min, spec.max);
    box->setSingleStep(Step(spec, decimals));
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, row, decimals](double value) {
      Edit(row, QString::number(value, 'f', decimals).toStdString());
    });
    return box;
  }
  if (std::holds_alternative<int*>(spec.target)) {
    auto* box = new QSpinBox(this);
    box->setRange(static_cast<int>(spec.min), static_cast<int>(spec.max));
    box->setKeyboardTracking(false);
    connect(box, &QSpinBox::valueChanged, this, [this, row](int value) { Edit(row, std::to_string(value)); });
    return box;
  }
  if (std::holds_alternative<bool*>(spec.target)) {
    auto* box = new QCheckBox(this);
    connect(box, &QCheckBox::toggled, this, [this, row](bool on) { Edit(row, on ? "true" : "false"); });
    return box;
  }
  auto* box = new QComboBox(this);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(6);
  for (const std::string& choice : spec.choices) box->addItem(QString::fromStdString(choice));
  connect(box, &QComboBox::currentTextChanged, this,
          [this, row](const QString& text) { Edit(row, text.toStdString()); });
  return box;
}

void OptionPanel::Edit(std::size_t row, const std::string& value) {
  if (!showing_) undo_->push(new Change(this, row, value));
}

void OptionPanel::Apply(std::size_t row, const std::string& value) {
  // An editor offers only what its spec allows, so a refusal leaves the old value and is shown as such.
  static_cast<void>(table_->Set(rows_[row].spec->name, value));
  const std::string now = OptionTable::ValueText(*rows_[row].spec);
  const bool changed = now != std::exchange(rows_[row].value, now);
  Show(row);
  if (changed) emit Changed();
}

void OptionPanel::Show(std::size_t row) {
  showing_ = true;
  QWidget* editor = rows_[row].editor;
  const OptionSpec& spec = *rows_[row].spec;
  if (auto* const* number = std::get_if<double*>(&spec.target)) {
    qobject_cast<QDoubleSpinBox*>(editor)->setValue(**number);
  } else if (auto* const* whole = std::get_if<int*>(&spec.target)) {
    qobject_cast<QSpinBox*>(editor)->setValue(**whole);
  } else if (auto* const* flag = std::get_if<bool*>(&spec.target)) {
    qobject_cast<QCheckBox*>(editor)->setChecked(**flag);
  } else {
    qobject_cast<QComboBox*>(editor)->setCurrentText(QString::fromStdString(rows_[row].value));
  }
  showing_ = false;
}

// An undo stack that ends tells its listeners once more, which may have ended before.
OptionPanel::~OptionPanel() { undo_->blockSignals(true); }

QWidget* OptionPanel::Editor(const std::string& name) const {
  for (const Row& row : rows_) {
    if (row.spec->name == name) return row.editor;
  }
  return nullptr;
}

bool OptionPanel::IsDefault() const {
  for (const Row& row : rows_) {
    if (row.value != row.initial) return false;
  }
  return true;
}

void OptionPanel::Reset() {
  if (IsDefault()) return;
  auto* all = new QUndoCommand(tr("Reset"));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].value != rows_[i].initial) new Change(this, i, rows_[i].initial, all);
  }
  undo_->push(all);
}

}  // namespace dorsum
