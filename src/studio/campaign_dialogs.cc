// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_dialogs.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardPaths>
#include <utility>

#include "jobs/campaign_names.h"
#include "studio/campaign_table.h"
#include "studio/library_words.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Why there can be no new folder of this name there; empty: there can.
QString ProblemOfNewFolder(const QString& parent, const QString& name) {
  std::error_code ec;
  if (name.trimmed().isEmpty()) return FormDialog::tr("Give it a name.");
  if (name.contains('/') || name.startsWith('.'))
    return FormDialog::tr("The name becomes a folder: it holds no slash and does not begin with a point.");
  const fs::path above = parent.toStdString();
  if (!fs::is_directory(above, ec)) return FormDialog::tr("Choose a folder that is there, to put it in.");
  const fs::path dir = above / name.trimmed().toStdString();
  if (!fs::exists(dir, ec) || (fs::is_directory(dir, ec) && fs::is_empty(dir, ec))) return {};
  return FormDialog::tr("%1 is there already; choose another name.")
      .arg(QString::fromStdString(dir.string()));
}

// Where people keep what is theirs.
QString Documents() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  std::error_code ec;
  return fs::is_directory(documents.toStdString(), ec)
             ? documents
             : QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
}

QSpinBox* Number(int least, int most, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(least, most);
  return box;
}

}  // namespace

NewCampaignDialog::NewCampaignDialog(const fs::path& calibration, QWidget* parent)
    : FormDialog(tr("New campaign"), tr("&Begin"), parent),
      calibration_(calibration),
      name_(new QLineEdit(this)),
      seed_(new QLineEdit("1", this)),
      people_(Number(0, kMaxPeople, this)),
      sessions_(Number(1, kMaxSessions, this)),
      captures_(Number(1, kMaxCaptures, this)),
      hands_(new QComboBox(this)),
      with_calibration_(new QCheckBox(tr("The one that is open"), this)),
      virtual_(new QCheckBox(tr("Captured without a device"), this)) {
  AddField(tr("&Name:"), name_, "name", tr("A name for people to read, and the name of the folder"));
  parent_ = AddFolder(tr("&In the folder:"), "parent", tr("The campaign becomes a folder of its own in it"));
  parent_->setText(Documents());
  people_->setSpecialValueText(tr("not said"));
  people_->setValue(20);
  AddField(tr("&People:"), people_, "people", tr("How many people are hoped for"));
  AddField(tr("&Sessions:"), sessions_, "sessions", tr("Visits of each person"));
  AddField(tr("C&aptures:"), captures_, "captures", tr("Captures of each hand in each session"));
  hands_->addItem(tr("both"), "both");
  hands_->addItem(tr("left"), "left");
  hands_->addItem(tr("right"), "right");
  AddField(tr("&Hands:"), hands_, "hands", tr("Which hands are captured"));
  with_calibration_->setEnabled(!calibration.empty());
  with_calibration_->setChecked(!calibration.empty());
  AddField(tr("&Calibration:"), with_calibration_, "withCalibration",
           calibration.empty() ? tr("No calibration is open. The first capture can bring one.")
                               : QString::fromStdString(calibration.string()));
  AddField(
      tr("&Virtual people:"), virtual_, "virtual",
      tr("Virtual people come to a virtual device, which is calibrated first. This takes minutes, and can be "
         "stopped and gone on with."));
  AddField(tr("S&eed:"), seed_, "seed", tr("Another seed is another virtual device with other people"));
  seed_->setEnabled(false);
  connect(virtual_, &QCheckBox::toggled, this, [this](bool on) {
    seed_->setEnabled(on);
    with_calibration_->setEnabled(!on && !calibration_.empty());
    Check();
  });
  connect(name_, &QLineEdit::textChanged, this, &NewCampaignDialog::Check);
  connect(seed_, &QLineEdit::textChanged, this, &NewCampaignDialog::Check);
  connect(people_, &QSpinBox::valueChanged, this, &NewCampaignDialog::Check);
  Check();
}

QString NewCampaignDialog::FindProblem() const {
  QString folder = ProblemOfNewFolder(parent_->text(), name_->text());
  if (!folder.isEmpty()) return folder;
  const Status name = CheckCampaignName(name_->text().trimmed().toStdString());
  if (!name.ok()) return InOwnWords(name.error().message);
  if (is_virtual() && people_->value() == 0) return tr("Say how many virtual people are to come.");
  if (is_virtual() && (seed_->text().isEmpty() || seed_->text().toStdString().size() > 200))
    return tr("A seed has 1 to 200 characters.");
  return {};
}

bool NewCampaignDialog::is_virtual() const { return virtual_->isChecked(); }

fs::path NewCampaignDialog::Dir() const {
  return fs::path(parent_->text().toStdString()) / name_->text().trimmed().toStdString();
}

CampaignPlan NewCampaignDialog::Plan() const {
  CampaignPlan plan;
  plan.people = people_->value();
  plan.sessions = sessions_->value();
  plan.captures = captures_->value();
  if (const auto hand = HandOfWord(hands_->currentData().toString().toStdString())) plan.hands = {*hand};
  return plan;
}

CreateCampaignRequest NewCampaignDialog::request() const {
  return {Dir(),
          name_->text().trimmed().toStdString(),
          Plan(),
          {},
          with_calibration_->isChecked() ? calibration_ : fs::path()};
}

VirtualCampaignRequest NewCampaignDialog::virtual_request() const {
  return {Dir(), name_->text().trimmed().toStdString(), Plan(), seed_->text().toStdString(), {}, {}};
}

PersonDialog::PersonDialog(const std::optional<CampaignPerson>& known, QStringList taken, QWidget* parent)
    : FormDialog(known ? tr("Correct a person") : tr("Add a person"), known ? tr("&Correct") : tr("&Add"),
                 parent),
      taken_(std::move(taken)),
      id_(new QLineEdit(this)),
      sex_(new QComboBox(this)),
      age_(new QComboBox(this)),
      signed_(new QCheckBox(tr("The person has signed it"), this)),
      consent_(new QDateEdit(QDate::currentDate(), this)) {
  AddField(
      tr("&Id:"), id_, "id",
      tr("Pseudonymous, as p01; never a name. The list that says who p01 is belongs on paper, in another "
         "place."));
  for (const std::string& word : CampaignSexes()) sex_->addItem(SexTitle(word), QString::fromStdString(word));
  for (const std::string& word : CampaignAgeGroups())
    age_->addItem(AgeTitle(word), QString::fromStdString(word));
  AddField(tr("&Sex:"), sex_, "sex", tr("As the person says"));
  AddField(tr("A&ge group:"), age_, "age", tr("In years"));
  AddField(tr("C&onsent:"), signed_, "signed", tr("Without the consent nothing is stored"));
  consent_->setDisplayFormat("yyyy-MM-dd");
  consent_->setCalendarPopup(true);
  AddField(tr("Signed o&n:"), consent_, "consent",
           tr("The day on which the person signed the consent. Without it nothing is stored."));
  const CampaignPerson start = known.value_or(CampaignPerson{"", "not-said", "not-said", "", false});
  id_->setText(QString::fromStdString(start.id));
  id_->setReadOnly(known.has_value());
  sex_->setCurrentIndex(sex_->findData(QString::fromStdString(start.sex)));
  age_->setCurrentIndex(age_->findData(QString::fromStdString(start.age_group)));
  is_virtual_ = start.is_virtual;
  signed_->setChecked(known && !is_virtual_);
  for (QWidget* widget : {static_cast<QWidget*>(signed_), static_cast<QWidget*>(consent_)})
    widget->setEnabled(!is_virtual_);
  if (!start.consent_date.empty())
    consent_->setDate(QDate::fromString(QString::fromStdString(start.consent_date), Qt::ISODate));
  connect(id_, &QLineEdit::textChanged, this, &PersonDialog::Check);
  connect(signed_, &QCheckBox::toggled, this, &PersonDialog::Check);
  connect(consent_, &QDateEdit::dateChanged, this, &PersonDialog::Check);
  Check();
}

CampaignPerson PersonDialog::person() const {
  return {id_->text().trimmed().toStdString(), sex_->currentData().toString().toStdString(),
          age_->currentData().toString().toStdString(),
          is_virtual_ ? "" : consent_->date().toString(Qt::ISODate).toStdString(), is_virtual_};
}

QString PersonDialog::FindProblem() const {
  const CampaignPerson answers = person();
  if (answers.id.empty()) return tr("Give the person an id, as p01; never a name.");
  const Status id = CheckPersonId(answers.id);
  if (!id.ok()) return InOwnWords(id.error().message);
  if (!id_->isReadOnly() && taken_.contains(QString::fromStdString(answers.id), Qt::CaseInsensitive))
    return tr("%1 is in the campaign already; choose another id.").arg(id_->text().trimmed());
  if (is_virtual_) return {};
  if (!signed_->isChecked()) return tr("Nothing is stored of a person who has not signed the consent.");
  const Status date = CheckConsentDate(answers.consent_date, Today());
  return date.ok() ? QString() : InOwnWords(date.error().message);
}

ExportDialog::ExportDialog(const fs::path& campaign, QWidget* parent)
    : FormDialog(tr("Export the campaign"), tr("E&xport"), parent),
      name_(new QLineEdit(this)),
      groups_(new QCheckBox(tr("Tell sex and age group too"), this)),
      least_(Number(2, 1000, this)) {
  AddField(tr("&Name:"), name_, "name", tr("The name of the new folder"));
  parent_ = AddFolder(tr("&In the folder:"), "parent", tr("The export becomes a folder of its own in it"));
  parent_->setText(Documents());
  AddField(
      tr("&Groups:"), groups_, "groups",
      tr("Only where groups are large enough. Without it, nobody is told anything but the pictures under new "
         "random ids."));
  least_->setValue(ExportRequest{}.least);
  least_->setEnabled(false);
  AddField(tr("&Least:"), least_, "least", tr("People that each group must have to be told"));
  connect(groups_, &QCheckBox::toggled, least_, &QWidget::setEnabled);
  connect(name_, &QLineEdit::textChanged, this, &ExportDialog::Check);
  name_->setText(QString::fromStdString(campaign.filename().string()) + "-for-others");
  Check();
}

ExportRequest ExportDialog::request() const {
  ExportRequest request;
  request.out_dir = fs::path(parent_->text().toStdString()) / name_->text().trimmed().toStdString();
  request.groups = groups_->isChecked();
  request.least = least_->value();
  return request;
}

QString ExportDialog::FindProblem() const { return ProblemOfNewFolder(parent_->text(), name_->text()); }

}  // namespace dorsum
