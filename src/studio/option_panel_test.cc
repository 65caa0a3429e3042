// SPDX-License-Identifier: Apache-2.0
#include "studio/option_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QUndoStack>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include "jobs/reconstruct_options.h"
#include "studio/option_box.h"

namespace dorsum {
namespace {

TEST(OptionPanel, EveryOptionOfAReconstructionHasAnEditorThatShowsIt) {
  ReconstructOptions options;
  OptionTable table = DescribeReconstructOptions(&options);
  std::vector<std::string> before;
  for (const OptionSpec& spec : table.specs()) before.push_back(OptionTable::ValueText(spec));
  const OptionPanel panel(&table);
  ASSERT_FALSE(table.specs().empty());
  for (std::size_t i = 0; i < table.specs().size(); ++i) {
    const OptionSpec& spec = table.specs()[i];
    SCOPED_TRACE(spec.name);
    EXPECT_EQ(OptionTable::ValueText(spec), before[i]) << "making the panel changed it";
    QWidget* editor = panel.Editor(spec.name);
    ASSERT_NE(editor, nullptr);
    EXPECT_TRUE(editor->toolTip().contains(QString::fromStdString(spec.help).toHtmlEscaped()));
    EXPECT_FALSE(editor->accessibleName().isEmpty());
    if (const auto* number = qobject_cast<QDoubleSpinBox*>(editor)) {
      EXPECT_EQ(number->value(), **std::get_if<double*>(&spec.target));
      EXPECT_EQ(number->minimum(), spec.min);
      EXPECT_EQ(number->maximum(), spec.max);
    } else if (const auto* whole = qobject_cast<QSpinBox*>(editor)) {
      EXPECT_EQ(whole->value(), **std::get_if<int*>(&spec.target));
    } else {
      const auto* box = qobject_cast<QComboBox*>(editor);
      ASSERT_NE(box, nullptr);
      EXPECT_EQ(box->count(), static_cast<int>(spec.choices.size()));
      EXPECT_EQ(box->currentText().toStdString(), before[i]);
    }
  }
  EXPECT_EQ(panel.Editor("no-such-option"), nullptr);
}

struct Values {
  double number = 2.5;
  int whole = 7;
  bool flag = false;
  std::string word = "one";
};

class OptionPanelTest : public ::testing::Test {
 protected:
  OptionPanelTest() {
    table_.Add("number", &values_.number, 0.0, 10.0, "a number, mm");
    table_.Add("whole", &values_.whole, 1, 99, "a whole number, px");
    table_.Add("flag", &values_.flag, "a switch");
    table_.Add("word", &values_.word, {"one", "two"}, "a choice");
    panel_ = std::make_unique<OptionPanel>(&table_);
  }
  template <class T>
  T* Editor(const std::string& name) {
    return qobject_cast<T*>(panel_->Editor(name));
  }

  Values values_;
  OptionTable table_;
  std::unique_ptr<OptionPanel> panel_;
};

TEST_F(OptionPanelTest, WhatIsSetIsInTheTableAndCanBeUndone) {
  QSignalSpy changed(panel_.get(), &OptionPanel::Changed);
  Editor<QDoubleSpinBox>("number")->setValue(3.25);
  Editor<QSpinBox>("whole")->setValue(8);
  Editor<QCheckBox>("flag")->setChecked(true);
  Editor<QComboBox>("word")->setCurrentText("two");
  EXPECT_EQ(values_.number, 3.25);
  EXPECT_EQ(values_.whole, 8);
  EXPECT_TRUE(values_.flag);
  EXPECT_EQ(values_.word, "two");
  EXPECT_EQ(changed.count(), 4);
  EXPECT_FALSE(panel_->IsDefault());
  panel_->undo()->undo();
  EXPECT_EQ(values_.word, "one");
  EXPECT_EQ(Editor<QComboBox>("word")->currentText(), "one");
  EXPECT_TRUE(values_.flag);
  panel_->undo()->redo();
  EXPECT_EQ(values_.word, "two");
  panel_->Reset();
  EXPECT_TRUE(panel_->IsDefault());
  EXPECT_EQ(values_.number, 2.5);
  EXPECT_FALSE(Editor<QCheckBox>("flag")->isChecked());
  panel_->undo()->undo();
  EXPECT_EQ(values_.whole, 8) << "a reset is one step";
  EXPECT_EQ(values_.number, 3.25);
}

TEST_F(OptionPanelTest, TypingCountsWhenItIsFinishedAndNothingBeyondTheRangeGetsIn) {
  QSignalSpy changed(panel_.get(), &OptionPanel::Changed);
  auto* box = Editor<QSpinBox>("whole");
  panel_->show();
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "42");
  EXPECT_EQ(changed.count(), 0);
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(values_.whole, 42);
  EXPECT_EQ(changed.count(), 1);
  box->setValue(100000);
  EXPECT_EQ(values_.whole, 99);
  Editor<QDoubleSpinBox>("number")->setValue(std::nan(""));
  EXPECT_GE(values_.number, 0.0);
  EXPECT_LE(values_.number, 10.0);
}

TEST_F(OptionPanelTest, AWheelOverThePanelChangesNothing) {
  auto* box = Editor<QSpinBox>("whole");
  panel_->show();
  box->clearFocus();
  QWheelEvent wheel(QPointF(5, 5), box->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(box, &wheel);
  EXPECT_EQ(values_.whole, 7);
}

// The window of a person has one undo, also where a number box with its own has the keyboard.
TEST(OptionBoxTest, KeysOfUndoTakeBackAStepEvenInANumberBox) {
  Values values;
  OptionTable table;
  table.Add("whole", &values.whole, 1, 99, "a whole number, px");
  OptionBox box(&table, "Parameters");
  box.show();
  box.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&box));
  auto* editor = qobject_cast<QSpinBox*>(box.panel()->Editor("whole"));
  editor->setFocus();
  for (int i = 0; i < 3; ++i) QTest::keyClick(editor, Qt::Key_Up);
  box.panel()->EndStep();
  QTest::keyClick(editor, Qt::Key_Up);
  ASSERT_EQ(values.whole, 11);
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(values.whole, 10);
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(values.whole, 7) << "what was turned in one go is one step";
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(values.whole, 10);
  editor->selectAll();
  QTest::keyClicks(editor, "55");
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(values.whole, 10) << "what is being typed is taken back first";
}

}  // namespace
}  // namespace dorsum
