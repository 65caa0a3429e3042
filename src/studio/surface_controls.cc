// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_controls.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QStandardItemModel>
#include <utility>
#include <vector>

#include "studio/named_widget.h"

namespace dorsum {
namespace {

using Mode = SurfaceMeasurer::Mode;

constexpr const char* kShowKey = "surface/show";
constexpr const char* kColoursKey = "surface/colours";

QStandardItem* ItemOf(const QComboBox* box, int value) {
  const auto* model = qobject_cast<QStandardItemModel*>(box->model());
  return model == nullptr ? nullptr : model->item(box->findData(value));
}

void Enable(QComboBox* box, int value, bool enabled) {
  if (QStandardItem* item = ItemOf(box, value)) item->setEnabled(enabled);
}

// What is wished for where that is possible, else `other`.
void Settle(QComboBox* box, int wished, int other) {
  const QStandardItem* item = ItemOf(box, wished);
  box->setCurrentIndex(box->findData(item != nullptr && item->isEnabled() ? wished : other));
}

}  // namespace

SurfaceControls::SurfaceControls(QWidget* parent)
    : QWidget(parent),
      show_(new QComboBox(this)),
      colours_(new QComboBox(this)),
      modes_(new QButtonGroup(this)),
      clear_(new QPushButton(tr("C&lear"), this)),
      compare_(new QPushButton(tr("Com&pare…"), this)),
      export_(new QPushButton(tr("&Export…"), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  AddChoices(row);
  RememberChoices();
  AddModes(row);
  row->addStretch(1);
  AddFiles(row);
}

void SurfaceControls::AddChoices(QHBoxLayout* row) {
  Named(show_, "show", tr("What is shown"), tr("The mesh, the points of the stripes, or both"));
  show_->addItem(tr("Mesh"), static_cast<int>(Shown::kMesh));
  show_->addItem(tr("Points"), static_cast<int>(Shown::kPoints));
  show_->addItem(tr("Mesh and points"), static_cast<int>(Shown::kBoth));
  Named(colours_, "colours", tr("Colours"), tr("What the colours of the surface mean"));
  const std::vector<std::pair<QString, ColourBy>> kinds = {
      {tr("Height"), ColourBy::kHeight},         {tr("Order of the stripe"), ColourBy::kOrder},
      {tr("Laser"), ColourBy::kLaser},           {tr("Uncertainty of z"), ColourBy::kUncertainty},
      {tr("Difference"), ColourBy::kDifference}, {tr("Shaded only"), ColourBy::kShaded}};
  for (const auto& [text, by] : kinds) colours_->addItem(text, static_cast<int>(by));
  for (auto [text, box] : {std::pair(tr("&Show:"), show_), std::pair(tr("&Colours:"), colours_)}) {
    auto* label = new QLabel(text, this);
    label->setBuddy(box);
    row->addWidget(label);
    row->addWidget(box);
  }
  connect(show_, &QComboBox::currentIndexChanged, this, &SurfaceControls::ShownChanged);
  connect(colours_, &QComboBox::currentIndexChanged, this, &SurfaceControls::ColoursChanged);
}

// What a person chooses here is chosen the next time too, as far as the surface then has it. A difference is
// to one other surface, and is not.
void SurfaceControls::RememberChoices() {
  const QSettings settings;
  wished_show_ = settings.value(kShowKey, static_cast<int>(Shown::kMesh)).toInt();
  wished_colours_ = settings.value(kColoursKey, static_cast<int>(ColourBy::kHeight)).toInt();
  connect(show_, &QComboBox::activated, this, [this] {
    wished_show_ = show_->currentData().toInt();
    QSettings().setValue(kShowKey, wished_show_);
  });
  connect(colours_, &QComboBox::activated, this, [this] {
    wished_colours_ = colours_->currentData().toInt();
    if (wished_colours_ != static_cast<int>(ColourBy::kDifference)) {
      QSettings().setValue(kColoursKey, wished_colours_);
    }
  });
}

void SurfaceControls::AddModes(QHBoxLayout* row) {
  struct Choice {
    Mode mode;
    const char* object;
    QString text, help;
  };
  for (const Choice& choice : {Choice{Mode::kPick, "modePick", tr("&Place"),
                                      tr("Say where a place lies and which stripe runs there")},
                               Choice{Mode::kDistance, "modeDistance", tr("&Distance"),
                                      tr("Two places: how far along the surface, and straight")},
                               Choice{Mode::kSection, "modeSection", tr("Sec&tion"),
                                      tr("Two places: the upright cut through both, as a curve")}}) {
    auto* button = new QPushButton(choice.text, this);
    Named(button, choice.object, QString(choice.text).remove('&'), choice.help);
    button->setCheckable(true);
    modes_->addButton(button, static_cast<int>(choice.mode));
    row->addWidget(button);
  }
  Named(clear_, "clear", tr("Clear the measure"), tr("Take the chosen places away"));
  row->addWidget(clear_);
  connect(modes_, &QButtonGroup::idClicked, this, [this](int id) { emit ModeChosen(static_cast<Mode>(id)); });
  connect(clear_, &QPushButton::clicked, this, &SurfaceControls::ClearWanted);
}

void SurfaceControls::AddFiles(QHBoxLayout* row) {
  Named(compare_, "compare", tr("Compare with another surface"),
        tr("Colours show how far this surface lies above or below that of another PLY file"));
  Named(export_, "export", tr("Export"), tr("Write the surface as PLY, OBJ, STL or GLB, or the view as PNG"));
  row->addWidget(compare_);
  row->addWidget(export_);
  connect(compare_, &QPushButton::clicked, this, &SurfaceControls::CompareWanted);
  connect(export_, &QPushButton::clicked, this, &SurfaceControls::ExportWanted);
}

Shown SurfaceControls::shown() const { return static_cast<Shown>(show_->currentData().toInt()); }
ColourBy SurfaceControls::colours() const { return static_cast<ColourBy>(colours_->currentData().toInt()); }

void SurfaceControls::Offer(bool mesh, bool points, bool difference) {
  export_->setEnabled(mesh || points);
  compare_->setEnabled(mesh || points);
  for (const ColourBy by : {ColourBy::kOrder, ColourBy::kLaser, ColourBy::kUncertainty}) {
    Enable(colours_, static_cast<int>(by), points);
  }
  Enable(colours_, static_cast<int>(ColourBy::kDifference), difference);
  Settle(colours_, wished_colours_, static_cast<int>(ColourBy::kHeight));
  for (const Shown what : {Shown::kMesh, Shown::kPoints, Shown::kBoth}) {
    Enable(show_, static_cast<int>(what),
           (mesh || what == Shown::kPoints) && (points || what == Shown::kMesh));
  }
  Settle(show_, wished_show_, static_cast<int>(mesh || !points ? Shown::kMesh : Shown::kPoints));
}

void SurfaceControls::ChooseDifference(const QString& other) {
  wished_colours_ = static_cast<int>(ColourBy::kDifference);
  const int difference = colours_->findData(wished_colours_);
  colours_->setItemText(difference, tr("Difference to %1").arg(other));
  Enable(colours_, wished_colours_, true);
  if (colours_->currentIndex() == difference) return emit ColoursChanged();
  colours_->setCurrentIndex(difference);
}

void SurfaceControls::ShowState(const SurfaceMeasurer& measurer) {
  modes_->button(static_cast<int>(measurer.mode()))->setChecked(true);
  clear_->setEnabled(!measurer.places().empty());
}

}  // namespace dorsum
