// SPDX-License-Identifier: Apache-2.0
#include "studio/device_page.h"

#include <QComboBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStyle>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

#include "studio/library_words.h"
#include "studio/wrapped_tree.h"

namespace dorsum {
namespace {

QLabel* WrappedLabel(QWidget* parent, const QString& name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QTreeWidget* MakeTable(const QStringList& header, const QString& name, const QString& title,
                       QWidget* parent) {
  auto* table = new QTreeWidget(parent);
  table->setObjectName(name);
  table->setAccessibleName(title);
  table->setHeaderLabels(header);
  table->setRootIsDecorated(false);
  WrapWords(table);
  table->setAlternatingRowColors(true);
  return table;
}

}  // namespace

DevicePage::DevicePage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent), model_(workbench), picture_(new FittedPicture(tr("Live picture"), this)) {
  setObjectName("devicePage");
  picture_->setObjectName("livePicture");
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(MakeChooser());
  column->addWidget(MakeLights());
  column->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(side);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(fontMetrics().averageCharWidth() * 52);
  auto* right = new QSplitter(Qt::Vertical, this);
  right->setObjectName("deviceSplit");
  right->addWidget(picture_);
  right->addWidget(MakeTables());
  right->setStretchFactor(0, 3);
  right->setStretchFactor(1, 2);
  right->setChildrenCollapsible(false);
  auto* row = new QHBoxLayout(this);
  row->addWidget(scroll);
  row->addWidget(right, 1);
  connect(&model_, &DeviceModel::DeviceChanged, this, &DevicePage::ShowDevice);
  connect(&model_, &DeviceModel::LightsChanged, this, &DevicePage::ShowLights);
  connect(&model_, &DeviceModel::Examined, this, &DevicePage::ShowReport);
  connect(&workbench->device(), &DeviceSession::FrameReady, this, [this](const cv::Mat& picture) {
    if (entered_) picture_->Show(FittedPicture::ImageOf(picture));
  });
  connect(&workbench->device(), &DeviceSession::Failed, this, [this](const Error& error) {
    picture_->Clear(tr("No picture: %1").arg(InOwnWords(error.message)));
    if (this->workbench()->device().facts())
      state_->setText(tr("The device does not answer. Open it again."));
  });
  ShowDevice();
}

QWidget* DevicePage::MakeChooser() {
  auto* box = new QGroupBox(tr("Device"), this);
  auto* column = new QVBoxLayout(box);
  which_ = new QComboBox(box);
  which_->setObjectName("which");
  which_->setEditable(true);
  which_->setInsertPolicy(QComboBox::NoInsert);
  which_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  which_->setMinimumContentsLength(12);
  which_->setAccessibleName(tr("Device"));
  which_->setToolTip(
      tr("A device description (device.toml), or virtual; virtual:7 is another virtual device, "
         "with the mounting errors of seed 7."));
  auto* browse = new QPushButton(tr("&Browse…"), box);
  browse->setObjectName("browse");
  auto* open = new QPushButton(tr("&Open"), box);
  open->setObjectName("open");
  open->setToolTip(tr("Opens the device named above, in place of the one that is open."));
  close_ = new QPushButton(tr("C&lose"), box);
  close_->setObjectName("close");
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {browse, open, close_}) buttons->addWidget(button);
  state_ = WrappedLabel(box, "state");
  column->addWidget(which_);
  column->addLayout(buttons);
  column->addWidget(state_);
  connect(browse, &QPushButton::clicked, this, &DevicePage::Browse);
  connect(open, &QPushButton::clicked, this, [this] {
    state_->setText(tr("Opening…"));
    model_.Open(which_->currentText());
    if (which_->currentText().trimmed().isEmpty()) ShowDevice();
  });
  connect(close_, &QPushButton::clicked, this, [this] { model_.Close(); });
  return box;
}

QWidget* DevicePage::MakeLights() {
  auto* box = new QGroupBox(tr("Lights by hand"), this);
  auto* column = new QVBoxLayout(box);
  rows_ = new QVBoxLayout;
  all_off_ = new QPushButton(style()->standardIcon(QStyle::SP_DialogCancelButton), tr("&All off"), box);
  all_off_->setObjectName("allOff");
  all_off_->setShortcut(Qt::CTRL | Qt::Key_Period);
  all_off_->setToolTip(tr("Switches every light off at once (Ctrl+.)."));
  QFont bold = all_off_->font();
  bold.setBold(true);
  all_off_->setFont(bold);
  lit_ = WrappedLabel(box, "lit");
  safety_ = WrappedLabel(box, "safety");
  column->addLayout(rows_);
  column->addWidget(all_off_);
  column->addWidget(lit_);
  column->addWidget(safety_);
  connect(all_off_, &QPushButton::clicked, this, [this] { model_.AllOff(); });
  return box;
}

QWidget* DevicePage::MakeTables() {
  auto* tabs = new QTabWidget(this);
  settings_ = MakeTable({tr("Setting"), tr("Value")}, "settings", tr("Camera settings"), tabs);
  tabs->addTab(settings_, tr("Camera &settings"));
  auto* examination = new QWidget(tabs);
  auto* column = new QVBoxLayout(examination);
  auto* examine = new QPushButton(tr("&Examine"), examination);
  examine->setObjectName("examine");
  examine->setToolTip(
      tr("Looks at cameras, ports, disk and calibration, then takes a picture in the dark, under the LEDs "
         "and under each laser. Clear the backplane first."));
  findings_ =
      MakeTable({tr("Part"), tr("Finding"), tr("What to do")}, "findings", tr("Findings"), examination);
  findings_->header()->setSectionResizeMode(QHeaderView::Stretch);
  findings_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  column->addWidget(findings_, 1);
  column->addWidget(examine, 0, Qt::AlignLeft);
  tabs->addTab(examination, tr("E&xamination"));
  tabs->setObjectName("tables");
  connect(examine, &QPushButton::clicked, this, [this] { model_.Examine(which_->currentText()); });
  return tabs;
}

void DevicePage::Enter() {
  entered_ = true;
  model_.Watch(true);
}

void DevicePage::Leave() {
  entered_ = false;
  model_.Watch(false);
}

void DevicePage::Browse() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Choose a device description"), {},
                                                    tr("Device descriptions (*.toml)"));
  if (path.isEmpty()) return;
  which_->setCurrentText(path);
  model_.Open(path);
}

void DevicePage::ShowDevice() {
  const auto& facts = workbench()->device().facts();
  const QString typed = which_->currentText();
  which_->clear();
  which_->addItems(DeviceModel::Recent());
  which_->setCurrentText(facts             ? QString::fromStdString(facts->name)
                         : typed.isEmpty() ? which_->itemText(0)
                                           : typed);
  close_->setEnabled(facts.has_value());
  if (facts) {
    state_->setText(tr("Open: %1. %2; %3, firmware %4.")
                        .arg(QString::fromStdString(facts->description.name), InOwnWords(facts->camera),
                             InOwnWords(facts->controller.name),
                             QString::fromStdString(facts->controller.firmware_version)));
    picture_->Clear(tr("Waiting for a picture…"));
  } else {
    state_->setText(tr("No device is open."));
    picture_->Clear(tr("No device is open. Choose one at the left; virtual needs no hardware."));
  }
  settings_->clear();
  for (const CameraSetting& setting : model_.CameraSettings()) {
    auto* item = new QTreeWidgetItem(settings_, {setting.name, setting.value});
    if (setting.failed) item->setIcon(0, style()->standardIcon(QStyle::SP_MessageBoxWarning));
  }
  settings_->resizeColumnToContents(0);
  for (QPushButton* toggle : toggles_) toggle->deleteLater();
  toggles_.clear();
  for (std::size_t i = 0; i < model_.switches().size(); ++i) {
    auto* toggle = new QPushButton(this);
    toggle->setCheckable(true);
    toggle->setObjectName("light" + QString::number(i));
    toggle->setAccessibleName(model_.switches()[i].name);
    connect(toggle, &QPushButton::toggled, this, [this, i](bool on) { model_.Switch(i, on); });
    rows_->addWidget(toggle);
    toggles_.push_back(toggle);
  }
  ShowReport();
  ShowLights();
}

void DevicePage::ShowLights() {
  for (std::size_t i = 0; i < toggles_.size() && i < model_.switches().size(); ++i) {
    const LightSwitch& one = model_.switches()[i];
    const QSignalBlocker quiet(toggles_[i]);
    toggles_[i]->setChecked(one.on);
    const int left = static_cast<int>(std::ceil(model_.SecondsLeft(i)));
    toggles_[i]->setText(!one.on     ? tr("%1: off").arg(one.name)
                         : one.laser ? tr("%1: on, off by itself in %2 s").arg(one.name).arg(left)
                                     : tr("%1: on").arg(one.name));
  }
  lit_->setText(model_.LitWords());
  lit_->setVisible(!lit_->text().isEmpty());
  safety_->setText(model_.SafetyWords());
}

void DevicePage::ShowReport() {
  findings_->clear();
  if (!model_.report()) return;
  for (const DoctorFinding& finding : model_.report()->findings) {
    auto* item = new QTreeWidgetItem(
        findings_,
        {InOwnWords(finding.subject), ClausesInOwnWords(finding.sentence), InOwnWords(finding.remedy)});
    const bool fine = finding.health == DoctorFinding::Health::kFine;
    const bool broken = finding.health == DoctorFinding::Health::kBroken;
    item->setIcon(0, style()->standardIcon(fine     ? QStyle::SP_DialogApplyButton
                                           : broken ? QStyle::SP_MessageBoxCritical
                                                    : QStyle::SP_MessageBoxInformation));
    item->setData(0, Qt::AccessibleDescriptionRole, fine ? tr("fine") : broken ? tr("broken") : tr("note"));
    for (int c = 1; c < 3; ++c) item->setToolTip(c, item->text(c));
  }
}

}  // namespace dorsum
