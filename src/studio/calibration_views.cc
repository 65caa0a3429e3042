// SPDX-License-Identifier: Apache-2.0
#include "studio/calibration_views.h"

#include <QBoxLayout>
#include <QListWidget>
#include <QStyle>
#include <QTreeWidget>
#include <utility>

#include "studio/fitted_picture.h"
#include "studio/library_words.h"
#include "studio/wrapped_tree.h"

namespace dorsum {
namespace {

QTreeWidget* MakeTable(const QString& name, const QString& title, const QStringList& header,
                       QWidget* parent) {
  auto* table = new QTreeWidget(parent);
  table->setObjectName(name);
  table->setAccessibleName(title);
  table->setHeaderLabels(header);
  table->setAlternatingRowColors(true);
  WrapWords(table);
  return table;
}

QListWidget* MakeList(const QString& name, const QString& title, QWidget* parent) {
  auto* list = new QListWidget(parent);
  list->setObjectName(name);
  list->setAccessibleName(title);
  list->setFixedWidth(parent->fontMetrics().averageCharWidth() * 40);
  return list;
}

QString Value(const std::optional<double>& value) {
  return value ? QString::number(*value, 'g', 5) : QString("–");
}

QStyle::StandardPixmap SignOf(Grade grade) {
  return grade == Grade::kGood       ? QStyle::SP_DialogApplyButton
         : grade == Grade::kDoubtful ? QStyle::SP_MessageBoxWarning
                                     : QStyle::SP_MessageBoxCritical;
}

// A list at the left, pictures beside it.
QWidget* Beside(QListWidget* list, const std::vector<QWidget*>& pictures, QWidget* parent) {
  auto* page = new QWidget(parent);
  auto* row = new QHBoxLayout(page);
  row->addWidget(list);
  auto* column = new QVBoxLayout;
  for (QWidget* picture : pictures) column->addWidget(picture, 1);
  row->addLayout(column, 1);
  return page;
}

}  // namespace

CalibrationViews::CalibrationViews(QWidget* parent)
    : QTabWidget(parent),
      parts_(MakeTable("parts", tr("Verdicts"), {tr("Part"), tr("Verdict")}, this)),
      changes_(MakeTable("changes", tr("Before and after"),
                         {tr("Part"), tr("Figure"), tr("Before"), tr("After"), tr("Change"), tr("Unit")},
                         this)),
      board_list_(MakeList("boardList", tr("Boards"), this)),
      sheet_list_(MakeList("sheetList", tr("Lasers"), this)),
      board_(new FittedPicture(tr("The board with arrows to where its corners are expected"), this)),
      over_order_(new FittedPicture(tr("What the light sheets leave, order by order"), this)),
      over_y_(new FittedPicture(tr("What the light sheets leave along the stripes"), this)) {
  board_->setObjectName("boardPicture");
  over_order_->setObjectName("sheetPicture");
  board_list_->setToolTip(
      tr("Each board with its reprojection error. The arrows are drawn many times longer."));
  sheet_list_->setToolTip(
      tr("Noise scatters evenly about zero; a pattern is an error of the model, or a laser that moved."));
  changes_->setRootIsDecorated(false);
  addTab(parts_, tr("&Verdicts"));
  addTab(Beside(board_list_, {board_}, this), tr("&Boards"));
  addTab(Beside(sheet_list_, {over_order_, over_y_}, this), tr("&Light sheets"));
  addTab(changes_, tr("Before and &after"));
  connect(board_list_, &QListWidget::currentRowChanged, this, &CalibrationViews::ChooseBoard);
  connect(sheet_list_, &QListWidget::currentRowChanged, this, &CalibrationViews::ChooseSheets);
  Show(nullptr, {});
}

void CalibrationViews::Show(std::shared_ptr<const CalibrationOutcome> outcome,
                            const std::vector<PartReport>& loaded) {
  outcome_ = std::move(outcome);
  ShowParts(outcome_ ? outcome_->parts : loaded, outcome_ ? outcome_->warnings : std::vector<std::string>{});
  board_list_->clear();
  sheet_list_->clear();
  const QString nothing = tr("Nothing was calibrated here yet.");
  for (FittedPicture* picture : {board_, over_order_, over_y_}) picture->Clear(nothing);
  ShowChanges();
  if (!outcome_) return;
  for (const CalibrationOutcome::Board& board : outcome_->boards) {
    board_list_->addItem(tr("%1: %2 px").arg(board.name).arg(board.rms_px, 0, 'f', 3));
  }
  for (const CalibrationOutcome::Sheets& sheets : outcome_->sheets) {
    sheet_list_->addItem(tr("Laser %1").arg(sheets.laser));
  }
  board_list_->setCurrentRow(0);
  sheet_list_->setCurrentRow(0);
}

void CalibrationViews::ShowParts(const std::vector<PartReport>& parts,
                                 const std::vector<std::string>& warnings) {
  parts_->clear();
  for (const std::string& warning : warnings) {
    auto* item = new QTreeWidgetItem(parts_, {tr("Warning"), ClausesInOwnWords(warning)});
    item->setIcon(0, style()->standardIcon(QStyle::SP_MessageBoxWarning));
  }
  for (const PartReport& part : parts) {
    const QString grade = part.grade == Grade::kGood       ? tr("good")
                          : part.grade == Grade::kDoubtful ? tr("doubtful")
                                                           : tr("bad");
    auto* item = new QTreeWidgetItem(
        parts_, {InOwnWords(part.part), tr("%1: %2").arg(grade, ClausesInOwnWords(part.verdict))});
    item->setIcon(0, style()->standardIcon(SignOf(part.grade)));
    item->setToolTip(1, item->text(1));
    for (const Figure& figure : part.figures) {
      new QTreeWidgetItem(
          item, {InOwnWords(figure.name), Value(figure.value) + " " + QString::fromStdString(figure.unit)});
    }
    item->setExpanded(part.grade != Grade::kGood);
  }
  parts_->setColumnWidth(0, fontMetrics().averageCharWidth() * 40);
}

void CalibrationViews::ShowChanges() {
  changes_->clear();
  if (!outcome_ || !outcome_->has_before) {
    new QTreeWidgetItem(changes_, {outcome_ ? tr("No calibration was loaded before.") : QString()});
    return;
  }
  for (const FigureChange& c : outcome_->changes) {
    const QString change = c.before && c.after ? QString::number(*c.after - *c.before, 'g', 3) : QString("–");
    auto* item = new QTreeWidgetItem(changes_, {InOwnWords(c.part), InOwnWords(c.figure), Value(c.before),
                                                Value(c.after), change, QString::fromStdString(c.unit)});
    for (int column = 2; column < 5; ++column) item->setTextAlignment(column, Qt::AlignRight);
  }
  for (int column = 0; column < 6; ++column) changes_->resizeColumnToContents(column);
}

void CalibrationViews::ChooseBoard(int row) {
  if (outcome_ && row >= 0) board_->Show(outcome_->boards.at(static_cast<std::size_t>(row)).picture);
}

void CalibrationViews::ChooseSheets(int row) {
  if (!outcome_ || row < 0) return;
  const CalibrationOutcome::Sheets& sheets = outcome_->sheets.at(static_cast<std::size_t>(row));
  over_order_->Show(sheets.over_order);
  over_y_->Show(sheets.over_y);
}

}  // namespace dorsum
