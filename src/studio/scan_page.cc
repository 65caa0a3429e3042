// SPDX-License-Identifier: Apache-2.0
#include "studio/scan_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "studio/live_view.h"
#include "studio/turning_surface.h"

namespace dorsum {
namespace {

void Enlarge(QWidget* widget, double factor) {
  QFont font = widget->font();
  font.setPointSizeF(factor * font.pointSizeF());
  widget->setFont(font);
}

// Words between which no line ends.
QString Together(QString words) { return words.replace(' ', QChar::Nbsp); }

}  // namespace

ScanPage::ScanPage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent),
      model_(new ScanModel(workbench, this)),
      sentence_(new QLabel(this)),
      steps_(new QLabel(this)),
      quality_(new QLabel(this)),
      folder_(new QLabel(this)),
      stack_(new QStackedWidget(this)),
      live_(new LiveView(this)),
      surface_(MakeSurfaceWidget(this)),
      button_(new QPushButton(this)),
      repeat_(new QPushButton(tr("&Repeat"), this)),
      choose_(new QPushButton(tr("Keep &in…"), this)),
      automatic_(new QCheckBox(tr("&Automatic"), this)),
      place_label_(new QLabel(tr("&Before the device:"), this)),
      place_(new QComboBox(this)) {
  sentence_->setObjectName("sentence");
  sentence_->setAccessibleName(tr("What to do"));
  sentence_->setAlignment(Qt::AlignCenter);
  sentence_->setWordWrap(true);
  Enlarge(sentence_, 2.2);
  steps_->setObjectName("steps");
  steps_->setAccessibleName(tr("Progress of the scan"));
  steps_->setAlignment(Qt::AlignCenter);
  steps_->setWordWrap(true);
  quality_->setObjectName("quality");
  quality_->setAccessibleName(tr("Quality of the fingers"));
  quality_->setAlignment(Qt::AlignCenter);
  quality_->setWordWrap(true);
  quality_->setToolTip(
      tr("How much of each finger the surface covers, and the usual uncertainty of its heights"));
  folder_->setObjectName("folder");
  folder_->setAlignment(Qt::AlignCenter);
  folder_->setWordWrap(true);
  // A path is one long word, which must not make the window wider than the screen.
  folder_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  folder_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  stack_->addWidget(live_);
  stack_->addWidget(surface_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(sentence_);
  column->addWidget(stack_, 1);
  column->addWidget(steps_);
  column->addWidget(quality_);
  column->addWidget(folder_);
  auto* places = new QHBoxLayout;
  places->addStretch(1);
  places->addWidget(place_label_);
  places->addWidget(place_);
  places->addStretch(1);
  column->addLayout(places);
  auto* row = new QHBoxLayout;
  AddControls(row);
  column->addLayout(row);
  connect(model_, &ScanModel::Changed, this, &ScanPage::Update);
  connect(model_, &ScanModel::ViewChanged, this, [this] { live_->Show(model_->view()); });
  connect(workbench, &Workbench::CalibrationChanged, this, &ScanPage::Update);
  connect(&workbench->device(), &DeviceSession::Opened, this, [this] { place_->setCurrentIndex(0); });
  Update();
}

void ScanPage::AddControls(QHBoxLayout* row) {
  AddPlaces();
  row->addStretch(1);
  button_->setObjectName("scan");
  Enlarge(button_, 1.6);
  button_->setDefault(true);
  button_->setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
  button_->setMinimumWidth(button_->fontMetrics().averageCharWidth() * 20);
  repeat_->setObjectName("repeat");
  repeat_->setToolTip(tr("Throw this scan away and take another"));
  Enlarge(repeat_, 1.6);
  row->addWidget(button_);
  row->addWidget(repeat_);
  row->addStretch(1);
  automatic_->setObjectName("automatic");
  automatic_->setToolTip(tr("Scan when the hand has rested for a second; again when it has moved since"));
  choose_->setObjectName("choose");
  choose_->setToolTip(tr("The folder in which captures are kept, each in a folder of its own"));
  row->addWidget(automatic_);
  row->addWidget(choose_);
  connect(button_, &QPushButton::clicked, this, &ScanPage::Press);
  connect(repeat_, &QPushButton::clicked, model_, &ScanModel::Repeat);
  connect(automatic_, &QCheckBox::toggled, model_, &ScanModel::SetAutomatic);
  connect(choose_, &QPushButton::clicked, this, [this] {
    const QString dir = QFileDialog::getExistingDirectory(this, tr("Keep captures in"));
    if (!dir.isEmpty()) model_->SetFolder(dir.toStdString());
    Update();
  });
}

void ScanPage::AddPlaces() {
  place_->setObjectName("place");
  place_->setAccessibleName(tr("What lies before the virtual device"));
  place_->addItem(tr("nothing"), "plane");
  place_->addItem(tr("Anna's right hand"), "hand:woman:right:anna");
  place_->addItem(tr("Anna's right hand, another day"), "hand:woman:right:anna:k1");
  place_->addItem(tr("Ben's left hand"), "hand:man:left:ben");
  place_->addItem(tr("Ben's left hand, which moves"), "hand:man:left:ben+moved2");
  place_->addItem(tr("a box, 25.5 mm high"), "box25.5");
  place_label_->setBuddy(place_);
  connect(place_, &QComboBox::activated, this,
          [this](int index) { model_->Place(place_->itemData(index).toString()); });
}

void ScanPage::Press() {
  switch (model_->state()) {
    case ScanState::kNoDevice:
      return workbench()->device().Open("virtual");
    case ScanState::kLost:
      return model_->Reconnect();
    case ScanState::kNoCalibration:
      return model_->is_virtual() ? model_->CalibrateVirtual() : ChooseCalibration();
    case ScanState::kPreview:
    case ScanState::kReady:
      return model_->Scan();
    case ScanState::kCapturing:
    case ScanState::kComputing:
    case ScanState::kCalibrating:
      return model_->Cancel();
    case ScanState::kShown:
      return model_->Keep();
    case ScanState::kKept:
      return model_->Repeat();
  }
}

QString ScanPage::ButtonText() const {
  switch (model_->state()) {
    case ScanState::kNoDevice:
      return tr("&Open the virtual device");
    case ScanState::kLost:
      return tr("&Connect again");
    case ScanState::kNoCalibration:
      return model_->is_virtual() ? tr("&Calibrate this virtual device") : tr("&Open its calibration…");
    case ScanState::kPreview:
    case ScanState::kReady:
      return tr("&Scan");
    case ScanState::kCapturing:
    case ScanState::kComputing:
    case ScanState::kCalibrating:
      return tr("&Cancel");
    case ScanState::kShown:
      return tr("&Keep");
    case ScanState::kKept:
      return tr("&Next hand");
  }
  return {};
}

void ScanPage::ChooseCalibration() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Open the device's calibration"), {},
                                                    tr("Calibrations (*.json)"));
  if (!path.isEmpty()) workbench()->LoadCalibration(path.toStdString());
}

// One word for each picture, with a mark once it is taken.
QString ScanPage::StepsText() const {
  QStringList words;
  for (int i = 0; i < model_->steps().size(); ++i) {
    QString name = model_->steps()[i];
    if (name == "dark") name = tr("dark");
    if (name == "bgHand") name = tr("lamps");
    if (name == "bgHandAfter") name = tr("lamps again");
    if (name == "surface") name = tr("surface");
    if (name.startsWith("stripesHand")) name = tr("laser %1").arg(name.mid(11).toInt() + 1);
    const bool done = i < model_->steps_done(), now = i == model_->steps_done();
    words << Together((done ? "✓ " : now ? "▸ " : "· ") + name);
  }
  return words.join("   ");
}

QString ScanPage::QualityText() const {
  if (model_->fingers().empty()) return tr("Fingers: not told, since five cannot be separated");
  QStringList words;
  for (std::size_t i = 0; i < model_->fingers().size(); ++i) {
    const FingerQuality& finger = model_->fingers()[i];
    const QString text = tr("finger %1: %2 % covered, ±%3 mm");
    words << Together(
        text.arg(i + 1).arg(std::lround(100.0 * finger.covered)).arg(finger.sigma_mm, 0, 'f', 2));
  }
  return words.join("     ");
}

void ScanPage::Update() {
  const ScanState state = model_->state();
  const bool shown = state == ScanState::kShown || state == ScanState::kKept;
  const bool taking = state == ScanState::kCapturing || state == ScanState::kComputing;
  sentence_->setText(model_->Sentence());
  button_->setText(ButtonText());
  repeat_->setVisible(state == ScanState::kShown);
  steps_->setVisible(taking);
  if (taking) steps_->setText(StepsText());
  quality_->setVisible(shown);
  if (shown) quality_->setText(QualityText());
  const QString folder = QString::fromStdString(model_->folder().string());
  folder_->setVisible(shown);
  folder_->setText(state == ScanState::kKept
                       ? tr("Kept in %1").arg(QString::fromStdString(model_->taken()->folder.string()))
                       : tr("Is kept in %1").arg(folder));
  folder_->setToolTip(folder_->text());
  const bool play = model_->is_virtual();
  place_label_->setVisible(play);
  place_->setVisible(play);
  place_->setEnabled(state == ScanState::kPreview || state == ScanState::kReady ||
                     state == ScanState::kNoCalibration);
  const bool was_shown = stack_->currentWidget() == surface_;
  if (shown != was_shown) {
    surface_->Show(shown ? model_->taken() : nullptr);
    if (shown) {
      stack_->setCurrentWidget(surface_);
    } else {
      stack_->setCurrentWidget(live_);
    }
  }
}

}  // namespace dorsum
