// SPDX-License-Identifier: Apache-2.0
#include "studio/calibrate_page.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStyle>
#include <QTabWidget>
#include <cmath>

#include "studio/calibration_views.h"
#include "studio/coverage_view.h"

namespace dorsum {
namespace {

QPushButton* MakeButton(const QString& text, const char* name, const QString& help, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(help);
  return button;
}

}  // namespace

CalibratePage::CalibratePage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent), model_(workbench) {
  setObjectName("calibratePage");
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("calibrateTabs");
  tabs_->addTab(MakeSeries(), tr("&Series"));
  auto* result = new QWidget(tabs_);
  auto* result_column = new QVBoxLayout(result);
  views_ = new CalibrationViews(result);
  back_ = MakeButton(tr("&Go back to the calibration before"), "goBack",
                     tr("Puts the calibration back that the last one replaced."), result);
  result_column->addWidget(views_, 1);
  result_column->addWidget(back_, 0, Qt::AlignLeft);
  tabs_->addTab(result, tr("&Result"));
  auto* row = new QHBoxLayout;
  row->addWidget(MakeSide());
  row->addWidget(tabs_, 1);
  auto* column = new QVBoxLayout(this);
  column->addWidget(MakePlaces());
  column->addLayout(row, 1);
  connect(back_, &QPushButton::clicked, &model_, &CalibrateModel::GoBack);
  connect(&model_, &CalibrateModel::PlacesChanged, this, &CalibratePage::ShowPlaces);
  connect(&model_, &CalibrateModel::Changed, this, &CalibratePage::ShowSeries);
  connect(&model_, &CalibrateModel::BoardSeen, this, &CalibratePage::ShowBoards);
  connect(&model_, &CalibrateModel::PictureReady, this,
          [this](const cv::Mat& picture) { picture_->Show(FittedPicture::ImageOf(picture)); });
  connect(&model_, &CalibrateModel::Calibrated, this, [this] {
    ShowOutcome();
    if (model_.outcome()) tabs_->setCurrentIndex(1);
  });
  connect(workbench, &Workbench::CalibrationChanged, this, &CalibratePage::ShowOutcome);
  connect(&workbench->jobs(), &JobRunner::Started, this, &CalibratePage::ShowSeries);
  connect(&workbench->jobs(), &JobRunner::Finished, this, &CalibratePage::ShowSeries);
  ShowPlaces();
  ShowSeries();
  ShowBoards();
  ShowOutcome();
}

QWidget* CalibratePage::MakePlaces() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  folder_ = new QLineEdit(box);
  folder_->setObjectName("folder");
  folder_->setToolTip(tr("Where the pictures of the series are, or go. What is there already is kept."));
  file_ = new QLineEdit(box);
  file_->setObjectName("file");
  file_->setToolTip(tr("The calibration that is written; its report comes beside it."));
  const auto add = [&](int row, const QString& text, QLineEdit* edit, const char* name) {
    auto* label = new QLabel(text, box);
    label->setBuddy(edit);
    edit->setAccessibleName(QString(text).remove('&'));
    auto* browse = MakeButton(tr("Browse…"), name, {}, box);
    browse->setAccessibleName(tr("Browse: %1").arg(QString(text).remove('&')));
    grid->addWidget(label, row, 0);
    grid->addWidget(edit, row, 1);
    grid->addWidget(browse, row, 2);
    return browse;
  };
  connect(add(0, tr("Series &folder"), folder_, "browseFolder"), &QPushButton::clicked, this,
          &CalibratePage::BrowseFolder);
  connect(add(1, tr("Calibration f&ile"), file_, "browseFile"), &QPushButton::clicked, this,
          &CalibratePage::BrowseFile);
  connect(folder_, &QLineEdit::editingFinished, this,
          [this] { model_.SetFolder(folder_->text().toStdString()); });
  connect(file_, &QLineEdit::editingFinished, this, [this] { model_.SetFile(file_->text().toStdString()); });
  return box;
}

QWidget* CalibratePage::MakeSide() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  take_ = MakeButton(tr("&Take the series"), "take",
                     tr("Leads through the series with the open device. A series that was broken off goes on "
                        "where it ended."),
                     side);
  calibrate_ = MakeButton(tr("&Calibrate from the folder"), "calibrate",
                          tr("Calibrates from the pictures that the folder holds; needs no device."), side);
  steps_ = new QListWidget(side);
  steps_->setObjectName("steps");
  steps_->setAccessibleName(tr("Steps of the series"));
  steps_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  steps_->setSelectionMode(QAbstractItemView::NoSelection);
  column->addWidget(take_);
  column->addWidget(calibrate_);
  column->addWidget(steps_, 1);
  side->setFixedWidth(fontMetrics().averageCharWidth() * 48);
  connect(take_, &QPushButton::clicked, this, [this] {
    tabs_->setCurrentIndex(0);
    model_.Take();
  });
  connect(calibrate_, &QPushButton::clicked, &model_, &CalibrateModel::Calibrate);
  return side;
}

QWidget* CalibratePage::MakeSeries() {
  auto* page = new QWidget(tabs_);
  auto* column = new QVBoxLayout(page);
  words_ = new QLabel(page);
  words_->setObjectName("words");
  words_->setWordWrap(true);
  words_->setAccessibleName(tr("What to do"));
  QFont large = words_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  words_->setFont(large);
  words_->setMinimumHeight(2 * QFontMetrics(large).height());
  words_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  picture_ = new CoverageView(tr("Live picture with what the boards cover"), page);
  picture_->setObjectName("seriesPicture");
  picture_->Clear(tr("The live picture comes when the series is taken."));
  seen_ = new QLabel(page);
  seen_->setObjectName("seen");
  seen_->setWordWrap(true);
  next_ = MakeButton(tr("&Next"), "next", tr("What was asked for stands: take the pictures (Return)."), page);
  next_->setShortcut(Qt::Key_Return);
  next_->setIcon(style()->standardIcon(QStyle::SP_ArrowRight));
  stop_ = MakeButton(tr("Sto&p"), "stop", tr("Ends the series; what was taken is kept."), page);
  by_itself_ = new QCheckBox(tr("Go on &by itself"), page);
  by_itself_->setObjectName("byItself");
  by_itself_->setToolTip(tr("A virtual device lays things down by itself, without being asked."));
  covered_ = new QLabel(page);
  covered_->setObjectName("covered");
  auto* grid = new QCheckBox(tr("S&how what boards cover"), page);
  grid->setObjectName("showGrid");
  grid->setChecked(true);
  auto* row = new QHBoxLayout;
  row->addWidget(next_);
  row->addWidget(stop_);
  row->addWidget(by_itself_);
  row->addStretch(1);
  row->addWidget(covered_);
  row->addWidget(grid);
  column->addWidget(words_);
  column->addLayout(row);
  column->addWidget(picture_, 1);
  column->addWidget(seen_);
  connect(next_, &QPushButton::clicked, &model_, &CalibrateModel::Next);
  connect(stop_, &QPushButton::clicked, &model_, &CalibrateModel::Stop);
  connect(by_itself_, &QCheckBox::toggled, &model_, &CalibrateModel::GoOnByItself);
  connect(grid, &QCheckBox::toggled, picture_, &CoverageView::ShowGrid);
  return page;
}

void CalibratePage::Enter() { model_.Hide(false); }

// A series that waits goes on waiting, in the dark.
void CalibratePage::Leave() { model_.Hide(true); }

void CalibratePage::BrowseFolder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Choose the folder of the series"));
  if (!path.isEmpty()) model_.SetFolder(path.toStdString());
}

void CalibratePage::BrowseFile() {
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Choose where the calibration goes"), QString::fromStdString(model_.file().string()),
      tr("Calibrations (*.json)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (!path.isEmpty()) model_.SetFile(path.toStdString());
}

void CalibratePage::ShowPlaces() {
  folder_->setText(QString::fromStdString(model_.folder().string()));
  file_->setText(QString::fromStdString(model_.file().string()));
}

void CalibratePage::ShowSeries() {
  const bool open = workbench()->device().facts().has_value(), busy = workbench()->jobs().busy();
  const std::vector<StepRow>& rows = model_.steps();
  int done = 0;
  if (steps_->count() != static_cast<int>(rows.size())) {
    steps_->clear();
    for (const StepRow& row : rows) steps_->addItem(row.title);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    QListWidgetItem* item = steps_->item(static_cast<int>(i));
    const bool is_done = rows[i].state == StepRow::State::kDone, now = rows[i].state == StepRow::State::kNow;
    done += is_done ? 1 : 0;
    item->setText(tr("%1: %2").arg(rows[i].title, is_done ? tr("done") : now ? tr("now") : tr("missing")));
    item->setIcon(style()->standardIcon(is_done ? QStyle::SP_DialogApplyButton
                                        : now   ? QStyle::SP_ArrowRight
                                                : QStyle::SP_FileIcon));
    QFont font = item->font();
    font.setBold(now);
    item->setFont(font);
    if (now) steps_->scrollToItem(item);
  }
  take_->setText(done == 0 ? tr("&Take the series") : tr("Go on &taking the series"));
  take_->setEnabled(!model_.taking() && !busy);
  calibrate_->setEnabled(!model_.taking() && !busy);
  for (QLineEdit* edit : {folder_, file_}) edit->setEnabled(!model_.taking() && !busy);
  next_->setEnabled(model_.waiting());
  stop_->setEnabled(model_.taking());
  by_itself_->setEnabled(model_.CanGoByItself());
  words_->setText(!model_.words().isEmpty() ? model_.words()
                  : open                    ? tr("Take the series: you are led through it step by step.")
                         : tr("Open a device on the device page, or calibrate from a folder."));
  seen_->setText(model_.seen());
}

void CalibratePage::ShowBoards() {
  picture_->SetBoards(model_.coverage(), model_.boards());
  covered_->setText(model_.coverage()
                        ? tr("Covered: %1 %").arg(std::lround(100.0 * model_.coverage()->Share()))
                        : QString());
}

void CalibratePage::ShowOutcome() {
  const auto& loaded = workbench()->calibration();
  views_->Show(model_.outcome(), loaded ? loaded->calibration.parts : std::vector<PartReport>{});
  back_->setEnabled(model_.CanGoBack());
}

}  // namespace dorsum
