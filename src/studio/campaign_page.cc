// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_page.h"

#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "jobs/campaign_names.h"
#include "studio/campaign_details.h"
#include "studio/campaign_dialogs.h"
#include "studio/campaign_people.h"
#include "studio/campaign_table.h"
#include "studio/library_words.h"

namespace dorsum {
namespace {

constexpr int kThumbnailSide_px = 240;

// The campaign's folder, if the first thing that is dragged is one.
std::filesystem::path CampaignIn(const QMimeData* data) {
  for (const QUrl& url : data->urls()) {
    std::filesystem::path path = url.toLocalFile().toStdString();
    std::error_code ec;
    if (url.isLocalFile() && std::filesystem::exists(path / kCampaignJson, ec)) return path;
    break;
  }
  return {};
}

QString SummaryOf(const CampaignView& view) {
  const CampaignStatus& s = view.status;
  const QString people = s.campaign.plan.people > 0
                             ? CampaignPage::tr("%1 of %2 people").arg(s.people).arg(s.campaign.plan.people)
                             : CampaignPage::tr("%n person(s)", nullptr, s.people);
  return "<b>" + QString::fromStdString(s.campaign.name).toHtmlEscaped() + "</b><br>" +
         CampaignPage::tr("%1 are there, %2 of them with all captures; %3 of %4 captures.")
             .arg(people)
             .arg(s.complete)
             .arg(s.captures)
             .arg(s.planned_captures);
}

}  // namespace

CampaignPage::CampaignPage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent),
      model_(workbench),
      thumbnails_(kThumbnailSide_px),
      table_(new CampaignTable(&thumbnails_, this)),
      people_(new CampaignPeople(table_, this)),
      details_(new CampaignDetails(workbench, &model_, table_, &thumbnails_, this)),
      stack_(new QStackedWidget(this)),
      summary_(new QLabel(this)),
      said_(new QLabel(this)),
      warnings_(new QListWidget(this)) {
  setObjectName("campaignPage");
  setAcceptDrops(true);
  auto* split = new QSplitter(this);
  split->setObjectName("campaignSplit");
  split->addWidget(people_);
  split->addWidget(details_);
  split->setStretchFactor(0, 1);
  split->setChildrenCollapsible(false);
  said_->setObjectName("said");
  said_->setWordWrap(true);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  warnings_->setObjectName("warnings");
  warnings_->setAccessibleName(tr("Findings"));
  warnings_->setWordWrap(true);
  warnings_->setMaximumHeight(6 * fontMetrics().lineSpacing());
  warnings_->hide();
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins({});
  column->addWidget(MakeHeader());
  column->addWidget(split, 1);
  column->addWidget(said_);
  column->addWidget(warnings_);
  stack_->addWidget(MakeEmpty());
  stack_->addWidget(content);
  auto* all = new QVBoxLayout(this);
  all->addWidget(stack_);

  connect(people_, &CampaignPeople::Chosen, this, [this](const QModelIndex& cell) {
    if (cell.isValid()) place_ = table_->PlaceAt(cell);
    details_->Show(cell);
  });
  connect(people_, &CampaignPeople::AddWanted, this, &CampaignPage::AddPerson);
  connect(people_, &CampaignPeople::NothingMissing, this,
          [this] { said_->setText(tr("Nothing is missing of the people who came.")); });
  connect(&model_, &CampaignModel::Changed, this, &CampaignPage::ShowView);
  connect(&model_, &CampaignModel::Captured, this, [this] { go_on_ = true; });
  connect(&model_, &CampaignModel::Said, this, [this](const QString& sentence) {
    said_->setText(sentence);
    warnings_->hide();
  });
  connect(&model_, &CampaignModel::Warned, this, [this](const QStringList& sentences) {
    warnings_->clear();
    warnings_->addItems(sentences);
    warnings_->setVisible(!sentences.isEmpty());
  });
  connect(&workbench->jobs(), &JobRunner::Finished, this, &CampaignPage::Refresh, Qt::QueuedConnection);
  connect(&workbench->jobs(), &JobRunner::Started, this, &CampaignPage::Refresh);
  connect(&workbench->device(), &DeviceSession::TaskStarted, this, &CampaignPage::Refresh);
  connect(&workbench->device(), &DeviceSession::TaskFinished, this, &CampaignPage::Refresh,
          Qt::QueuedConnection);
  ShowView();
}

QPushButton* CampaignPage::Button(const QString& text, const char* name, const QString& help,
                                  QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(help);
  return button;
}

QWidget* CampaignPage::MakeEmpty() {
  auto* box = new QWidget(this);
  auto* words =
      new QLabel(tr("A campaign collects captures of many people: who came, which hands are there, and what "
                    "is missing. Open the folder of one, or begin a new one; one of virtual people needs no "
                    "device."),
                 box);
  words->setObjectName("emptyHint");
  words->setWordWrap(true);
  words->setAlignment(Qt::AlignCenter);
  auto* row = new QHBoxLayout;
  auto* open = Button(tr("&Open a campaign…"), "openFirst", tr("Opens the folder of a campaign"), box);
  auto* create = Button(tr("&New campaign…"), "newFirst", tr("Begins a campaign in a new folder"), box);
  row->addStretch(1);
  row->addWidget(open);
  row->addWidget(create);
  row->addStretch(1);
  auto* column = new QVBoxLayout(box);
  column->addStretch(1);
  column->addWidget(words);
  column->addLayout(row);
  column->addStretch(1);
  connect(open, &QPushButton::clicked, this, &CampaignPage::Open);
  connect(create, &QPushButton::clicked, this, &CampaignPage::New);
  return box;
}

QWidget* CampaignPage::MakeHeader() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins({});
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  row->addWidget(summary_, 1);
  auto* open = Button(tr("&Open…"), "open", tr("Opens the folder of another campaign"), box);
  auto* create = Button(tr("&New…"), "new", tr("Begins a campaign in a new folder"), box);
  verify_ = Button(tr("&Verify"), "verify", tr("Reads every byte: is all as it was stored?"), box);
  export_ = Button(tr("E&xport…"), "export",
                   tr("Writes the captures for others, under new random ids and without personal data"), box);
  for (QPushButton* button : {open, create, verify_, export_}) row->addWidget(button);
  connect(open, &QPushButton::clicked, this, &CampaignPage::Open);
  connect(create, &QPushButton::clicked, this, &CampaignPage::New);
  connect(verify_, &QPushButton::clicked, this, [this] { model_.Verify(); });
  connect(export_, &QPushButton::clicked, this, &CampaignPage::Export);
  return box;
}

void CampaignPage::Enter() {
  details_->Watch(true);
  if (std::exchange(entered_before_, true) || model_.view()) return;
  const std::filesystem::path last = CampaignModel::Last();
  if (!last.empty() && !workbench()->jobs().busy()) model_.Open(last);
}

void CampaignPage::Leave() { details_->Watch(false); }

void CampaignPage::Open() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open the folder of a campaign"));
  if (!path.isEmpty()) model_.Open(path.toStdString());
}

void CampaignPage::New() {
  NewCampaignDialog dialog(workbench()->calibration_path(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  if (dialog.is_virtual()) return model_.CreateVirtual(dialog.virtual_request());
  model_.Create(dialog.request());
}

void CampaignPage::AddPerson() {
  QStringList taken;
  for (const CampaignPersonView& person : model_.view()->people)
    taken << QString::fromStdString(person.person.id);
  PersonDialog dialog(std::nullopt, taken, this);
  if (dialog.exec() != QDialog::Accepted) return;
  place_ = {dialog.person().id, 0, std::nullopt};
  go_on_ = true;
  model_.AddPerson(dialog.person(), false);
}

void CampaignPage::Export() {
  ExportDialog dialog(model_.dir(), this);
  if (dialog.exec() == QDialog::Accepted) model_.Export(dialog.request());
}

void CampaignPage::ShowView() {
  const auto& view = model_.view();
  stack_->setCurrentIndex(view ? 1 : 0);
  if (!view) return Refresh();
  const CampaignPlace place = place_;  // resetting the table forgets it
  table_->SetView(view, model_.dir());
  summary_->setText(SummaryOf(*view));
  summary_->setToolTip(QString::fromStdString(model_.dir().string()));
  const std::optional<MissingCaptures> next = NextMissing(*view, {place.id, 0, std::nullopt});
  const CampaignPersonView* person = nullptr;
  for (const CampaignPersonView& p : view->people) {
    if (p.person.id == place.id) person = &p;
  }
  const CampaignHandView* hand =
      person != nullptr && place.hand ? FindHand(*person, place.session, *place.hand) : nullptr;
  const bool done = hand == nullptr || hand->missing == 0;
  if (std::exchange(go_on_, false) && next && done) {
    people_->Choose({next->id, next->session, next->hand});
  } else {
    people_->Choose(place);
  }
  if (!view->status.problems.empty()) {
    said_->setText(tr("Something of this campaign cannot be read, and does not count. Verify says more."));
    warnings_->clear();
    for (const std::string& problem : view->status.problems) warnings_->addItem(InOwnWords(problem));
    warnings_->show();
  }
  Refresh();
}

void CampaignPage::Refresh() {
  const bool idle = !model_.busy() && model_.view();
  for (QPushButton* button : {verify_, export_}) button->setEnabled(idle);
  // Real people and virtual ones do not mix.
  people_->SetAddingPossible(idle && !model_.view()->status.campaign.virtual_people);
  details_->Refresh();
}

void CampaignPage::dragEnterEvent(QDragEnterEvent* event) {
  if (!CampaignIn(event->mimeData()).empty()) event->acceptProposedAction();
}

void CampaignPage::dropEvent(QDropEvent* event) { model_.Open(CampaignIn(event->mimeData())); }

}  // namespace dorsum
