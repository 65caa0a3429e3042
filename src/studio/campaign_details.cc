// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_details.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>

#include "studio/campaign_dialogs.h"
#include "studio/campaign_model.h"
#include "studio/campaign_removal.h"
#include "studio/campaign_table.h"
#include "studio/fitted_picture.h"
#include "studio/library_words.h"

namespace dorsum {
namespace {

// Of a capture in the list: a picture and two lines below it.
QSize CaptureSize(const QWidget& widget) {
  const int em = widget.fontMetrics().height();
  return {11 * em, 10 * em};
}

}  // namespace

CampaignDetails::CampaignDetails(Workbench* workbench, CampaignModel* model, CampaignTable* table,
                                 CampaignThumbnails* thumbnails, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      model_(model),
      table_(table),
      captures_(new CampaignCaptures(thumbnails, CaptureSize(*this), this)),
      title_(new QLabel(this)),
      next_words_(new QLabel(this)),
      live_(new FittedPicture(tr("Live picture"), this)),
      list_(new QListView(this)) {
  title_->setObjectName("chosen");
  title_->setWordWrap(true);
  next_words_->setObjectName("next words");
  next_words_->setWordWrap(true);
  live_->setObjectName("campaignLive");
  const int em = fontMetrics().height();
  list_->setObjectName("captures");
  list_->setAccessibleName(tr("Captures"));
  list_->setModel(captures_);
  list_->setViewMode(QListView::IconMode);
  list_->setResizeMode(QListView::Adjust);
  list_->setMovement(QListView::Static);
  list_->setUniformItemSizes(true);
  list_->setLayoutMode(QListView::Batched);  // a person may have thousands
  list_->setWordWrap(true);
  list_->setIconSize({10 * em, 7 * em});
  list_->setSpacing(em / 4);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins({});
  column->addWidget(title_);
  column->addWidget(MakePersonButtons());
  column->addWidget(live_, 2);
  column->addWidget(next_words_);
  column->addWidget(MakeCaptureButtons());
  column->addWidget(list_, 3);
  auto* row = new QHBoxLayout;
  look_ = Button(tr("&Look at it"), "look",
                 tr("Reconstructs the chosen capture, for the pages Surface and Stages"), this);
  remove_capture_ = Button(tr("Remove &capture…"), "removeCapture",
                           tr("Deletes the chosen capture, to take it again"), this);
  row->addWidget(look_);
  row->addWidget(remove_capture_);
  column->addLayout(row);
  setMinimumWidth(fontMetrics().averageCharWidth() * 46);

  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &CampaignDetails::Refresh);
  connect(list_, &QListView::activated, look_, &QPushButton::click);
  connect(look_, &QPushButton::clicked, this, [this] {
    if (const CampaignCapture* chosen = Chosen()) model_->Look(*chosen);
  });
  connect(remove_capture_, &QPushButton::clicked, this, &CampaignDetails::RemoveCapture);
  auto* key = new QShortcut(QKeySequence::Delete, list_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(key, &QShortcut::activated, remove_capture_, [this] { remove_capture_->click(); });
  connect(&workbench->device(), &DeviceSession::FrameReady, this, [this](const cv::Mat& picture) {
    if (watched_) live_->Show(FittedPicture::ImageOf(picture));
  });
  connect(&workbench->device(), &DeviceSession::Opened, this, &CampaignDetails::ShowLive);
  connect(&workbench->device(), &DeviceSession::Closed, this, &CampaignDetails::ShowLive);
  connect(&workbench->device(), &DeviceSession::Failed, this, [this](const Error& error) {
    live_->setVisible(workbench_->device().facts().has_value());
    live_->Clear(tr("No picture: %1").arg(InOwnWords(error.message)));
    Refresh();
  });
  ShowLive();
}

QPushButton* CampaignDetails::Button(const QString& text, const char* name, const QString& help,
                                     QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(help);
  return button;
}

QWidget* CampaignDetails::MakePersonButtons() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins({});
  correct_ = Button(tr("C&orrect…"), "correct", tr("Replaces what was said of the person wrongly"), box);
  remove_person_ = Button(tr("Remove &person…"), "removePerson",
                          tr("Deletes the person with all captures, for good"), box);
  row->addWidget(correct_);
  row->addWidget(remove_person_);
  row->addStretch(1);
  connect(correct_, &QPushButton::clicked, this, &CampaignDetails::Correct);
  connect(remove_person_, &QPushButton::clicked, this, &CampaignDetails::RemovePerson);
  return box;
}

QWidget* CampaignDetails::MakeCaptureButtons() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins({});
  next_ = Button({}, "next", tr("Takes what is missing next, with the open device (Ctrl+Return)"), box);
  QFont bold = next_->font();
  bold.setBold(true);
  next_->setFont(bold);
  import_ =
      Button(tr("From a &folder…"), "import", tr("Takes over a capture that lies in a folder already"), box);
  row->addWidget(next_, 1);
  row->addWidget(import_);
  auto* key = new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return), this);
  connect(key, &QShortcut::activated, next_, [this] { next_->click(); });
  connect(next_, &QPushButton::clicked, this, &CampaignDetails::DoNext);
  connect(import_, &QPushButton::clicked, this, &CampaignDetails::Import);
  return box;
}

void CampaignDetails::Show(const QModelIndex& cell) {
  place_ = table_->PlaceAt(cell);
  const std::size_t lasers = model_->view() ? model_->view()->status.campaign.device.lasers.size() : 0;
  captures_->Set(table_->CapturesAt(cell), model_->dir(), lasers);
  if (captures_->rowCount() > 0) list_->setCurrentIndex(captures_->index(captures_->rowCount() - 1));
  const QString id = QString::fromStdString(place_.id);
  title_->setText(
      place_.id.empty() ? tr("Choose a person in the table, or add one.")
      : place_.hand
          ? "<b>" + tr("%1, session %2, %3").arg(id).arg(place_.session).arg(HandTitle(*place_.hand)) + "</b>"
          : "<b>" + id + "</b>");
  Refresh();
}

std::optional<MissingCaptures> CampaignDetails::Next() const {
  if (!model_->view() || place_.id.empty()) return std::nullopt;
  return NextMissing(*model_->view(), place_);
}

const CampaignPersonView* CampaignDetails::Person() const {
  if (!model_->view()) return nullptr;
  const auto& people = model_->view()->people;
  const auto it = std::find_if(people.begin(), people.end(),
                               [&](const CampaignPersonView& p) { return p.person.id == place_.id; });
  return it != people.end() ? &*it : nullptr;
}

const CampaignCapture* CampaignDetails::Chosen() const {
  const QModelIndex index = list_->currentIndex();
  return index.isValid() ? &captures_->captures()[static_cast<std::size_t>(index.row())] : nullptr;
}

QString CampaignDetails::NextWords() const {
  if (place_.id.empty()) return {};
  const auto next = Next();
  QString what = next ? tr("Next: session %1, %2; %3 missing.")
                            .arg(next->session)
                            .arg(HandTitle(next->hand))
                            .arg(next->count)
                      : tr("Nothing is missing here.");
  if (Person() != nullptr && Person()->person.is_virtual) {
    const CampaignStatus& status = model_->view()->status;
    const int missing = status.planned_captures - status.captures;
    return missing > 0 ? what + ' ' + tr("%n capture(s) are missing in all.", nullptr, missing) : what;
  }
  if (!next || workbench_->device().facts()) return what;
  return what + ' ' + tr("No device is open; open one on the Device page.");
}

// Virtual people come all, whoever is chosen.
bool CampaignDetails::AnyVirtualMissing() const {
  const CampaignStatus& status = model_->view()->status;
  return status.captures < status.planned_captures;
}

void CampaignDetails::Refresh() {
  const CampaignPersonView* person = Person();
  const bool idle = !model_->busy(), is_virtual = person != nullptr && person->person.is_virtual;
  const auto next = Next();
  next_words_->setText(NextWords());
  next_->setText(is_virtual ? tr("&Make all that is missing")
                 : next     ? tr("Capture the %1").arg(HandTitle(next->hand))
                            : tr("Capture"));
  next_->setEnabled(idle && (is_virtual ? AnyVirtualMissing() : next && workbench_->device().facts()));
  import_->setEnabled(idle && next && !is_virtual);
  look_->setEnabled(idle && Chosen() != nullptr);
  remove_capture_->setEnabled(idle && Chosen() != nullptr);
  correct_->setEnabled(idle && person != nullptr);
  remove_person_->setEnabled(idle && person != nullptr);
}

void CampaignDetails::DoNext() {
  if (Person() != nullptr && Person()->person.is_virtual) return model_->ContinueVirtual();
  if (const auto next = Next()) model_->Capture(*next);
}

void CampaignDetails::Import() {
  const auto next = Next();
  if (!next) return;
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Take over a capture folder"));
  if (!folder.isEmpty()) model_->Import(*next, folder.toStdString());
}

void CampaignDetails::RemoveCapture() {
  const CampaignCapture* chosen = Chosen();
  if (chosen == nullptr) return;
  const CampaignCapture capture = *chosen;  // the list may change while it is asked
  if (AskToRemoveCapture(capture, this)) model_->RemoveCapture(capture);
}

void CampaignDetails::RemovePerson() {
  const CampaignPersonView* person = Person();
  if (person == nullptr) return;
  const std::string id = person->person.id;
  if (AskToRemovePerson(id, table_->CapturesAt(table_->IndexOf({id, 0, std::nullopt})), this))
    model_->Remove(id);
}

void CampaignDetails::Correct() {
  if (Person() == nullptr) return;
  PersonDialog dialog(Person()->person, {}, this);
  if (dialog.exec() == QDialog::Accepted) model_->AddPerson(dialog.person(), true);
}

void CampaignDetails::Watch(bool watched) {
  watched_ = watched;
  ShowLive();
  if (!watched) workbench_->device().StopPreview();
}

void CampaignDetails::ShowLive() {
  const auto& facts = workbench_->device().facts();
  live_->setVisible(facts.has_value());
  live_->Clear(tr("Waiting for a picture…"));
  if (facts && watched_)
    workbench_->device().StartPreview(LedChannels(facts->description), FrameLight::kLeds);
  Refresh();
}

}  // namespace dorsum
