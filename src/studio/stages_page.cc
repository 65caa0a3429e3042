// SPDX-License-Identifier: Apache-2.0
#include "studio/stages_page.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>

#include "studio/option_box.h"
#include "studio/picture_view.h"
#include "studio/stage_words.h"

namespace dorsum {
namespace {

constexpr int kSettle_ms = 300;  // a person who turns a value is let finish

}  // namespace

StagesPage::StagesPage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent),
      table_(DescribeReconstructOptions(&options_)),
      box_(new OptionBox(&table_, tr("Parameters of both"), this)),
      list_(new QListWidget(this)),
      state_(new QLabel(this)),
      before_button_(new QPushButton(tr("Show &before"), this)),
      again_(new QPushButton(tr("&Compute"), this)),
      timer_(new QTimer(this)),
      classic_(new PictureView(this)),
      ours_(new PictureView(this)),
      classic_figures_(new QLabel(this)),
      ours_figures_(new QLabel(this)) {
  setObjectName("stagesPage");
  list_->setObjectName("stages");
  list_->setAccessibleName(tr("Stages of the chain"));
  list_->setToolTip(tr("A dot marks what the last change of a parameter changed"));
  timer_->setSingleShot(true);
  timer_->setInterval(kSettle_ms);
  auto* splitter = new QSplitter(this);
  splitter->setObjectName("stagesSplit");
  splitter->addWidget(list_);
  splitter->addWidget(MakeViews());
  splitter->addWidget(box_);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  const int em = fontMetrics().horizontalAdvance('M');
  list_->setMinimumWidth(fontMetrics().horizontalAdvance(StageTitle("mask/without_shadow")) + 3 * em);
  splitter->setSizes({list_->minimumWidth(), 80 * em, 20 * em});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins({});
  all->addWidget(splitter);

  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row < 0) return;
    stage_ = list_->item(row)->data(Qt::UserRole).toString().toStdString();
    ShowStage();
  });
  connect(timer_, &QTimer::timeout, this, [this] {
    box_->panel()->EndStep();
    Want();
  });
  connect(box_->panel(), &OptionPanel::Changed, this, [this] {
    stale_ = true;
    timer_->start();
    state_->setText(State());
  });
  connect(workbench, &Workbench::ScanChanged, this, [this] {
    comparison_.reset();
    before_.reset();
    const QSignalBlocker quiet(list_);
    list_->clear();
    Want();
  });
  connect(&workbench->jobs(), &JobRunner::Finished, this, &StagesPage::Start, Qt::QueuedConnection);
  wanted_ = stale_ = true;
  ShowStage();
}

QLayout* StagesPage::MakeState() {
  state_->setObjectName("state");
  state_->setAccessibleName(tr("What is shown"));
  state_->setWordWrap(true);
  before_button_->setObjectName("before");
  before_button_->setCheckable(true);
  before_button_->setToolTip(tr("Shows the pictures of the parameters before the last change, to compare"));
  again_->setObjectName("again");
  again_->setToolTip(tr("Computes the stages with the parameters as they are now"));
  connect(before_button_, &QPushButton::toggled, this, &StagesPage::ShowStage);
  connect(again_, &QPushButton::clicked, this, &StagesPage::Want);
  auto* row = new QHBoxLayout;
  row->addWidget(state_, 1);
  row->addWidget(again_);
  row->addWidget(before_button_);
  return row;
}

QWidget* StagesPage::MakeViews() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->addLayout(MakeState(), 0, 0, 1, 2);
  PictureView::Link(classic_, ours_);
  int column = 0;
  for (const auto& [view, figures, title, name] :
       {std::tuple(classic_, classic_figures_, tr("The document's chain"), "classic"),
        std::tuple(ours_, ours_figures_, tr("Ours"), "ours")}) {
    view->setObjectName(name);
    view->setAccessibleName(title);
    view->setToolTip(tr("Wheel or + and −: zoom; mouse or arrows: move; 0: all of it"));
    figures->setObjectName(QString(name) + "Figures");
    figures->setAccessibleName(tr("Figures: %1").arg(title));
    figures->setWordWrap(true);
    figures->setMinimumHeight(2 * figures->fontMetrics().lineSpacing());  // so that pictures do not jump
    figures->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    figures->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* heading = new QLabel("<b>" + title + "</b>", box);
    heading->setWordWrap(true);
    heading->setBuddy(view);
    // The pictures alone decide on the columns, not the longest word, so that both are as wide.
    for (QLabel* words : {heading, figures}) words->setMinimumWidth(1);
    view->setMinimumWidth(12 * fontMetrics().horizontalAdvance('M'));
    grid->addWidget(heading, 1, column);
    grid->addWidget(view, 2, column);
    grid->addWidget(figures, 3, column);
    grid->setColumnStretch(column, 1);
    ++column;
  }
  grid->setRowStretch(2, 1);
  return box;
}

OptionPanel* StagesPage::options() { return box_->panel(); }

void StagesPage::Enter() {
  here_ = true;
  Start();
}

void StagesPage::Leave() {
  here_ = false;
  if (running_) {
    wanted_ = true;
    workbench()->jobs().Cancel();
  }
}

void StagesPage::Want() {
  wanted_ = stale_ = true;
  if (running_) workbench()->jobs().Cancel();
  Start();
}

void StagesPage::Start() {
  const std::shared_ptr<const Scan> scan = workbench()->scan();
  const bool possible = scan && !scan->capture.hand.empty() && scan->calibration;
  if (!here_ || !wanted_ || !possible || workbench()->jobs().busy()) return ShowStage();
  wanted_ = false;
  running_ = true;
  ShowStage();
  workbench()->jobs().Run<std::shared_ptr<const StageComparison>>(
      tr("Comparing the stages"),
      [scan, options = options_, before = comparison_](const Context& context) {
        return CompareStages(*scan, options, before.get(), context);
      },
      [this, scan](Result<std::shared_ptr<const StageComparison>> now) {
        running_ = false;
        if (!now.ok()) {
          ShowStage();
          return workbench()->Fail(now.error());
        }
        if (scan == workbench()->scan()) TakeComparison(*now);
      });
}

void StagesPage::TakeComparison(const std::shared_ptr<const StageComparison>& now) {
  before_ = std::exchange(comparison_, now);
  stale_ = wanted_ || timer_->isActive();
  before_button_->setChecked(false);
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const std::string& key : now->keys) {
    const bool changed = now->changed.contains(key);
    auto* item =
        new QListWidgetItem((changed ? QString(QChar(0x2022)) + ' ' : QString()) + StageTitle(key), list_);
    item->setData(Qt::UserRole, QString::fromStdString(key));
    if (changed) item->setData(Qt::AccessibleDescriptionRole, tr("changed"));
    if (key == stage_) list_->setCurrentItem(item);
  }
  if (list_->currentRow() < 0 && list_->count() > 0) {
    list_->setCurrentRow(0);
    stage_ = now->keys.front();
  }
  ShowStage();
  if (!stale_) emit Compared();
}

QString StagesPage::Words() const {
  const auto& scan = workbench()->scan();
  if (!scan)
    return tr(
        "Scan a hand, or open a calibration and a capture folder (File menu): its stages are shown here.");
  if (scan->capture.hand.empty() || !scan->calibration)
    return tr("Only a surface is open, which has no stages. Open a capture folder (File menu).");
  if (running_) return tr("Computing…");
  if (wanted_) return tr("The stages come when the other work is done.");
  return tr("The computation was stopped. Compute begins it again.");
}

// How what is shown belongs to the parameters.
QString StagesPage::State() const {
  if (!comparison_) return {};
  if (before_button_->isChecked()) return tr("Before the last change of the parameters.");
  if (running_) return tr("Computing with the new parameters…");
  if (stale_ && (wanted_ || timer_->isActive())) return tr("The parameters changed.");
  if (stale_) return tr("The computation was stopped: these pictures are of other parameters.");
  if (!before_) return {};
  if (comparison_->changed.empty()) return tr("The last change of the parameters changed no picture.");
  return tr("The last change of the parameters changed %n picture(s); a dot marks them in the list.", nullptr,
            static_cast<int>(comparison_->changed.size()));
}

void StagesPage::ShowStage() {
  const StageComparison* shown = before_button_->isChecked() ? before_.get() : comparison_.get();
  const StageComparison* reference = shown == comparison_.get() ? before_.get() : nullptr;
  for (const auto& [view, figures, side] : {std::tuple(classic_, classic_figures_, &StageComparison::classic),
                                            std::tuple(ours_, ours_figures_, &StageComparison::ours)}) {
    if (shown == nullptr) {
      view->SetPicture({}, Words());
      figures->clear();
      continue;
    }
    const ChainStages& chain = (*shown).*side;
    const auto it = chain.pictures.find(stage_);
    view->SetPicture(
        it != chain.pictures.end() ? it->second : cv::Mat(),
        chain.error ? tr("This chain ended before this stage.") : tr("This chain has no such stage."));
    figures->setText(StageFigures(chain, reference != nullptr ? &((*reference).*side) : nullptr));
  }
  state_->setText(State());
  before_button_->setEnabled(before_ != nullptr);
  const auto& scan = workbench()->scan();
  const bool possible = scan && !scan->capture.hand.empty() && scan->calibration;
  again_->setVisible(possible && here_ && stale_ && !wanted_ && !running_ && !timer_->isActive());
}

}  // namespace dorsum
