// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_page.h"

#include <QBuffer>
#include <QButtonGroup>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSplitter>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <utility>

#include "base/files.h"
#include "studio/image_view.h"
#include "studio/scale_bar.h"
#include "studio/section_plot.h"
#include "studio/surface_export.h"
#include "studio/surface_view.h"

namespace dorsum {
namespace {

constexpr double kSectionReach_mm = 0.5;  // of points beside the plane, where there is no mesh
constexpr double kDot_mm = 0.25;          // between the dots of a line
constexpr const char* kShowKey = "surface/show";
constexpr const char* kColoursKey = "surface/colours";

template <class T>
T* Named(T* widget, const char* object, const QString& name, const QString& help) {
  widget->setObjectName(object);
  widget->setAccessibleName(name);
  widget->setToolTip(help);
  return widget;
}

void AppendLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, std::vector<Eigen::Vector3d>* dots) {
  const int steps = std::min(2000, 1 + static_cast<int>((b - a).norm() / kDot_mm));
  for (int i = 0; i <= steps; ++i) dots->emplace_back(a + (b - a) * (static_cast<double>(i) / steps));
}

QPointF ToQPoint(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

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

SurfacePage::SurfacePage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent),
      view_(new SurfaceView(this)),
      image_(new ImageView(this)),
      plot_(new SectionPlot(this)),
      scale_(new ScaleBar(this)),
      show_(new QComboBox(this)),
      colours_(new QComboBox(this)),
      images_(new QComboBox(this)),
      empty_(new QLabel(this)),
      readout_(new QLabel(this)),
      modes_(new QButtonGroup(this)),
      compare_(new QPushButton(tr("Com&pare…"), this)),
      export_(new QPushButton(tr("&Export…"), this)),
      clear_(new QPushButton(tr("C&lear"), this)) {
  Named(
      view_, "surfaceView", tr("Surface"),
      tr("Drag or arrow keys turn; Shift moves; wheel, + and - zoom; Home shows all; a click or Enter picks "
         "a place"));
  Named(plot_, "sectionPlot", tr("Section"), tr("The cut through the two places"));
  Named(scale_, "scaleBar", tr("Scale of the colours"), {});
  Named(readout_, "readout", tr("What was measured"), {});
  Named(empty_, "emptyHint", tr("No surface"), {});
  empty_->setText(tr("No surface yet. Scan a hand, open a capture folder or a PLY file, or drop one here."));
  empty_->setWordWrap(true);
  empty_->setAlignment(Qt::AlignCenter);
  readout_->setWordWrap(true);
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  readout_->setMinimumHeight(3 * readout_->fontMetrics().lineSpacing());
  readout_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* left = new QWidget(this);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(empty_, 1);
  column->addWidget(view_, 1);
  column->addWidget(scale_);
  column->addWidget(readout_);
  auto* split = new QSplitter(this);
  split->setObjectName("surfaceSplit");
  split->setChildrenCollapsible(false);
  split->addWidget(left);
  split->addWidget(MakeImageSide());
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 2);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(MakeControls());
  all->addWidget(split, 1);
  connect(workbench, &Workbench::ScanChanged, this, &SurfacePage::ScanChanged);
  connect(view_, &SurfaceView::Aimed, this, [this](const Ray& ray, double slope) {
    if (!scan_) return;
    const std::optional<Picked> picked = Pick(*scan_, ray, shown(), slope);
    if (picked) Take(*picked);
  });
  connect(view_, &SurfaceView::Unavailable, this, [this](const QString& why) {
    this->workbench()->Fail(Error{ErrorCode::kInternal, why.toStdString()});
  });
  connect(image_, &ImageView::Aimed, this, &SurfacePage::AimedAtImage);
  ScanChanged();
}

QWidget* SurfacePage::MakeImageSide() {
  Named(image_, "imageView", tr("Image"),
        tr("The image with its stripes; a click or Enter picks a stripe, the wheel, + and - zoom, Home shows "
           "all"));
  Named(images_, "images", tr("Image that is shown"), tr("Which of the capture's images, and whose stripes"));
  auto* label = new QLabel(tr("&Image:"), this);
  label->setBuddy(images_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(images_, 1);
  auto* top = new QWidget(this);
  auto* column = new QVBoxLayout(top);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(image_, 1);
  auto* side = new QSplitter(Qt::Vertical, this);
  side->setObjectName("surfaceSide");
  side->setChildrenCollapsible(false);
  side->addWidget(top);
  side->addWidget(plot_);
  side->setStretchFactor(0, 3);
  side->setStretchFactor(1, 2);
  connect(images_, &QComboBox::currentIndexChanged, this, &SurfacePage::ShowImage);
  return side;
}

QWidget* SurfacePage::MakeControls() {
  auto* controls = new QWidget(this);
  auto* row = new QHBoxLayout(controls);
  row->setContentsMargins(0, 0, 0, 0);
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
  RememberChoices();
  AddModes(row);
  row->addStretch(1);
  Named(compare_, "compare", tr("Compare with another surface"),
        tr("Colours show how far this surface lies above or below that of another PLY file"));
  Named(export_, "export", tr("Export"), tr("Write the surface as PLY, OBJ, STL or GLB, or the view as PNG"));
  row->addWidget(compare_);
  row->addWidget(export_);
  connect(show_, &QComboBox::currentIndexChanged, this, [this] { view_->SetShown(shown()); });
  connect(colours_, &QComboBox::currentIndexChanged, this, &SurfacePage::Rebuild);
  connect(compare_, &QPushButton::clicked, this, [this] {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Compare with a surface"), {}, tr("Surfaces (*.ply)"));
    if (!path.isEmpty()) CompareWith(path.toStdString());
  });
  connect(export_, &QPushButton::clicked, this, [this] {
    const bool mesh = !scan_->surface.mesh.faces.empty();
    const QString kinds_of_file =
        mesh ? tr("PLY (*.ply);;OBJ (*.obj);;STL (*.stl);;GLB (*.glb);;Picture (*.png)")
             : tr("PLY (*.ply);;Picture (*.png)");
    QFileDialog dialog(this, tr("Export"), {}, kinds_of_file);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("ply");
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
      dialog.setDefaultSuffix(filter.section("*.", 1).section(')', 0, 0));
    });
    if (dialog.exec() == QDialog::Accepted) ExportTo(dialog.selectedFiles().front().toStdString());
  });
  return controls;
}

// What a person chooses here is chosen the next time too, as far as the surface then has it. A difference is
// to one other surface, and is not.
void SurfacePage::RememberChoices() {
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

void SurfacePage::AddModes(QHBoxLayout* row) {
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
    Named(button, choice.object, choice.text, choice.help);
    button->setAccessibleName(QString(choice.text).remove('&'));
    button->setCheckable(true);
    modes_->addButton(button, static_cast<int>(choice.mode));
    row->addWidget(button);
  }
  modes_->button(static_cast<int>(mode_))->setChecked(true);
  Named(clear_, "clear", tr("Clear the measure"), tr("Take the chosen places away"));
  row->addWidget(clear_);
  connect(modes_, &QButtonGroup::idClicked, this, [this](int id) { SetMode(static_cast<Mode>(id)); });
  connect(clear_, &QPushButton::clicked, this, &SurfacePage::Clear);
}

Shown SurfacePage::shown() const { return static_cast<Shown>(show_->currentData().toInt()); }

std::optional<int> SurfacePage::laser() const {
  const int value = images_->currentData().toInt();
  return images_->currentIndex() < 0 || value < 0 ? std::nullopt : std::optional<int>(value);
}

void SurfacePage::ScanChanged() {
  scan_ = workbench()->scan();
  const bool mesh = scan_ && !scan_->surface.mesh.faces.empty();
  const bool points = scan_ && !scan_->surface.points.empty();
  empty_->setVisible(!mesh && !points);
  view_->setVisible(mesh || points);
  scale_->setVisible(mesh || points);
  export_->setEnabled(mesh || points);
  compare_->setEnabled(mesh || points);
  for (const ColourBy by : {ColourBy::kOrder, ColourBy::kLaser, ColourBy::kUncertainty}) {
    Enable(colours_, static_cast<int>(by), points);
  }
  Enable(colours_, static_cast<int>(ColourBy::kDifference), other_ != nullptr);
  Settle(colours_, wished_colours_, static_cast<int>(ColourBy::kHeight));
  for (const Shown what : {Shown::kMesh, Shown::kPoints, Shown::kBoth}) {
    Enable(show_, static_cast<int>(what),
           (mesh || what == Shown::kPoints) && (points || what == Shown::kMesh));
  }
  Settle(show_, wished_show_, static_cast<int>(mesh || !points ? Shown::kMesh : Shown::kPoints));
  view_->SetShown(shown());
  {
    const QSignalBlocker quiet(images_);
    images_->clear();
    images_->addItem(scan_ && scan_->capture.hand.empty() ? tr("All stripes") : tr("LEDs, all stripes"), -1);
    for (int k = 0; scan_ && k < static_cast<int>(scan_->capture.stripes.size()); ++k) {
      if (scan_->capture.stripes[static_cast<std::size_t>(k)]) images_->addItem(tr("Laser %1").arg(k), k);
    }
  }
  image_->parentWidget()->setVisible(points || (scan_ && !scan_->capture.hand.empty()));
  frame_ = true;
  ShowImage();
  Clear();
  Rebuild();
}

void SurfacePage::Rebuild() {
  build_again_ = building_.busy();
  if (build_again_ || !scan_) return;
  const auto by = static_cast<ColourBy>(colours_->currentData().toInt());
  building_.Run<std::shared_ptr<const SceneBuffers>>(
      tr("Colouring the surface"),
      [scan = scan_, by, other = other_](const Context&) -> Result<std::shared_ptr<const SceneBuffers>> {
        return std::make_shared<const SceneBuffers>(
            MakeBuffers(scan->surface, by, other ? *other : OtherHeight()));
      },
      [this, scan = scan_](Result<std::shared_ptr<const SceneBuffers>> buffers) {
        if (!buffers.ok()) return workbench()->Fail(buffers.error());
        if (scan == scan_) Built(*buffers);
      });
  connect(
      &building_, &JobRunner::Finished, this,
      [this] {
        if (build_again_) Rebuild();
      },
      Qt::SingleShotConnection);
}

void SurfacePage::Built(std::shared_ptr<const SceneBuffers> buffers) {
  buffers_ = std::move(buffers);
  view_->SetBuffers(buffers_, std::exchange(frame_, false));
  scale_->SetScale(buffers_->scale);
  Say();
}

void SurfacePage::ShowImage() {
  cv::Mat shown_image;
  if (scan_) {
    const std::optional<int> k = laser();
    shown_image = k ? *scan_->capture.stripes[static_cast<std::size_t>(*k)] : scan_->capture.hand;
  }
  image_->SetImage(ToQImage(shown_image));
  image_->SetStripes(scan_ ? scan_->surface.points : SurfacePoints(), laser());
}

void SurfacePage::AimedAtImage(const QPointF& pixel, double reach_px) {
  if (!scan_) return;
  const auto point = PickInImage(scan_->surface.points, {pixel.x(), pixel.y()}, laser(), reach_px);
  if (!point) return;
  const SurfacePoint& p = scan_->surface.points[*point];
  // From above, so that a measure knows the face of the mesh there.
  std::optional<Picked> picked;
  if (!scan_->surface.mesh.faces.empty()) {
    picked = Pick(*scan_, {p.position + Eigen::Vector3d(0, 0, 1000.0), {0, 0, -1}}, Shown::kMesh, 0.0);
  }
  if (!picked) picked.emplace();
  picked->position = p.position;
  picked->point = *point;
  picked->image = Eigen::Vector2d(p.u, p.v);
  Take(*picked);
}

void SurfacePage::Take(const Picked& picked) {
  if (mode_ == Mode::kPick || places_.size() >= 2) Clear();
  places_.push_back(picked);
  Highlight(picked.point);
  if (places_.size() == 2) Measure();
  ShowMarks();
  Say();
}

void SurfacePage::Highlight(std::optional<std::uint32_t> point) {
  stripe_dots_.clear();
  QPolygonF in_image;
  if (point) {
    const SurfacePoints& points = scan_->surface.points;
    const int now = images_->findData(static_cast<int>(points[*point].laser));
    if (laser() && now >= 0) images_->setCurrentIndex(now);
    for (const std::uint32_t i : PointsOfStripe(points, KeyOf(points[*point]))) {
      stripe_dots_.push_back(points[i].position);
      in_image.append(QPointF(points[i].u, points[i].v));
    }
  }
  std::optional<QPointF> place;
  if (!places_.empty() && places_.back().image) place = ToQPoint(*places_.back().image);
  image_->SetHighlight(in_image, place);
}

void SurfacePage::SetMode(Mode mode) {
  mode_ = mode;
  modes_->button(static_cast<int>(mode))->setChecked(true);
  // Two places that are there already are measured the other way at once.
  if (places_.size() == 2 && mode != Mode::kPick) {
    Measure();
    ShowMarks();
    Say();
  } else {
    Clear();
  }
}

void SurfacePage::Clear() {
  measuring_.Cancel();
  places_.clear();
  stripe_dots_.clear();
  distance_.reset();
  section_.reset();
  plot_->SetSection({});
  image_->SetHighlight({}, {});
  ShowMarks();
  Say();
}

void SurfacePage::Measure() {
  distance_.reset();
  section_.reset();
  plot_->SetSection({});
  if (mode_ == Mode::kSection) return Cut();
  if (mode_ == Mode::kDistance) MeasureDistance();
}

void SurfacePage::Cut() {
  const Reconstruction& surface = scan_->surface;
  Result<Section> section = Section{};
  if (surface.mesh.faces.empty()) {
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePoint& p : surface.points) points.push_back(p.position);
    section = CutPoints(points, places_[0].position, places_[1].position, kSectionReach_mm);
  } else {
    section = CutMesh(surface.mesh, places_[0].position, places_[1].position);
  }
  if (!section.ok()) return workbench()->Fail(section.error());
  section_ = *section;
  plot_->SetSection(*section_);
}

void SurfacePage::MeasureDistance() {
  if (!places_[0].face || !places_[1].face) return;  // points alone: the straight way is all there is
  measure_again_ = measuring_.busy();
  if (measure_again_) return measuring_.Cancel();
  measuring_.Run<SurfaceDistance>(
      tr("Measuring along the surface"),
      [scan = scan_, a = places_[0], b = places_[1]](const Context& context) {
        return MeasureAlong(scan->surface.mesh, {a.position, *a.face}, {b.position, *b.face}, context);
      },
      [this, scan = scan_, a = places_[0], b = places_[1]](Result<SurfaceDistance> distance) {
        const bool is_still = scan == scan_ && places_.size() == 2 && mode_ == Mode::kDistance &&
                              places_[0].position == a.position && places_[1].position == b.position;
        if (!is_still || measure_again_) return;
        if (!distance.ok()) return workbench()->Fail(distance.error());
        distance_ = *distance;
        ShowMarks();
        Say();
      });
  connect(
      &measuring_, &JobRunner::Finished, this,
      [this] {
        if (std::exchange(measure_again_, false) && places_.size() == 2 && mode_ == Mode::kDistance) {
          MeasureDistance();
        }
      },
      Qt::SingleShotConnection);
}

void SurfacePage::ShowMarks() {
  SceneMarks marks;
  for (const Picked& picked : places_) marks.places.push_back(picked.position);
  if (distance_) {
    for (std::size_t i = 1; i < distance_->path.size(); ++i) {
      AppendLine(distance_->path[i - 1], distance_->path[i], &marks.line);
    }
  } else if (section_ && places_.size() == 2) {
    const Eigen::Vector3d a = places_[0].position;
    const Eigen::Vector2d along = (places_[1].position - a).head<2>().normalized();
    const auto at = [&](const Eigen::Vector2d& p) {
      return Eigen::Vector3d(a.x() + p.x() * along.x(), a.y() + p.x() * along.y(), p.y());
    };
    for (const SectionCurve& curve : section_->curves) {
      for (std::size_t i = 1; i < curve.size(); ++i) AppendLine(at(curve[i - 1]), at(curve[i]), &marks.line);
    }
    for (const Eigen::Vector2d& p : section_->dots) marks.line.push_back(at(p));
  } else {
    marks.line = stripe_dots_;
  }
  view_->SetMarks(marks);
}

QString SurfacePage::PlaceText(const Picked& picked) const {
  const Eigen::Vector3d& p = picked.position;
  QString text = tr("x %1, y %2, z %3 mm").arg(p.x(), 0, 'f', 2).arg(p.y(), 0, 'f', 2).arg(p.z(), 0, 'f', 2);
  if (picked.image)
    text += tr("; image %1, %2 px").arg(picked.image->x(), 0, 'f', 1).arg(picked.image->y(), 0, 'f', 1);
  if (picked.point) {
    const SurfacePoint& point = scan_->surface.points[*picked.point];
    text += tr("; stripe of laser %1, order %2").arg(point.laser).arg(point.order);
    if (point.sigma > 0.0F) text += tr("; one standard deviation of z %1 mm").arg(point.sigma, 0, 'f', 3);
  }
  return text;
}

QString SurfacePage::MeasureText() const {
  if (places_.size() < 2) return {};
  const double straight = (places_[1].position - places_[0].position).norm();
  QString text = tr("Straight %1 mm").arg(straight, 0, 'f', 2);
  if (distance_) text += tr(", along the surface %1 mm").arg(distance_->along_mm, 0, 'f', 2);
  if (mode_ == Mode::kDistance && scan_->surface.mesh.faces.empty()) {
    text += tr("; points alone have no way along a surface");
  } else if (mode_ == Mode::kDistance && measuring_.busy() && !distance_) {
    text += tr(", measuring along the surface…");
  }
  return text;
}

void SurfacePage::Say() {
  QStringList lines;
  if (scan_ && places_.empty()) {
    lines << tr("%1: %2, %3")
                 .arg(QString::fromStdString(scan_->name),
                      tr("%Ln point(s)", "", static_cast<int>(scan_->surface.points.size())),
                      tr("%Ln triangle(s)", "", static_cast<int>(scan_->surface.mesh.faces.size())));
    if (mode_ == Mode::kPick) lines << tr("Click a place of the surface or a stripe of the image.");
  }
  if (scan_ && mode_ != Mode::kPick && places_.size() < 2) {
    lines << (places_.empty() ? tr("Click the first of two places.") : tr("Click the second place."));
  }
  const QString measured = MeasureText();
  if (!measured.isEmpty()) lines << measured;
  for (const Picked& picked : places_) lines << PlaceText(picked);
  if (buffers_ && scan_ && buffers_->scale.by == ColourBy::kDifference) {
    const DifferenceSummary& d = buffers_->difference;
    lines << tr("Against %1: mean %2 mm, RMS %3 mm; places compared: %L4, outside it: %L5")
                 .arg(other_name_)
                 .arg(d.mean_mm, 0, 'f', 3)
                 .arg(d.rms_mm, 0, 'f', 3)
                 .arg(d.compared)
                 .arg(d.outside);
  }
  readout_->setText(lines.join('\n'));
  clear_->setEnabled(!places_.empty());
}

void SurfacePage::CompareWith(const std::filesystem::path& path) {
  JobRunner& jobs = workbench()->jobs();
  if (jobs.busy()) {
    return workbench()->Fail(UsageError("something else is being done; wait for it, or cancel it"));
  }
  jobs.Run<std::shared_ptr<const OtherHeight>>(
      tr("Reading %1").arg(QString::fromStdString(path.filename().string())),
      [path](const Context&) -> Result<std::shared_ptr<const OtherHeight>> {
        DORSUM_ASSIGN_OR_RETURN(const std::shared_ptr<const Scan> other, ReadSurface(path));
        return std::make_shared<const OtherHeight>(MakeOtherHeight(other->surface));
      },
      [this, path](Result<std::shared_ptr<const OtherHeight>> other) {
        if (!other.ok()) return workbench()->Fail(other.error());
        other_ = *other;
        other_name_ = QString::fromStdString(path.filename().string());
        wished_colours_ = static_cast<int>(ColourBy::kDifference);
        const int difference = colours_->findData(wished_colours_);
        colours_->setItemText(difference, tr("Difference to %1").arg(other_name_));
        Enable(colours_, static_cast<int>(ColourBy::kDifference), true);
        if (colours_->currentIndex() == difference) return Rebuild();
        colours_->setCurrentIndex(difference);
      });
}

void SurfacePage::ExportTo(const std::filesystem::path& path) {
  if (!scan_) return workbench()->Fail(UsageError("there is no surface to export; scan or open one first"));
  JobRunner& jobs = workbench()->jobs();
  if (jobs.busy()) {
    return workbench()->Fail(UsageError("something else is being done; wait for it, or cancel it"));
  }
  QImage picture;
  if (path.extension() == ".png") picture = view_->Picture();
  jobs.Run<bool>(
      tr("Writing %1").arg(QString::fromStdString(path.filename().string())),
      [path, picture, scan = scan_](const Context&) -> Result<bool> {
        if (path.extension() != ".png") {
          DORSUM_RETURN_IF_ERROR(ExportSurface(scan->surface, path));
          return true;
        }
        QByteArray bytes;
        QBuffer buffer(&bytes);
        if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG")) {
          return Error{ErrorCode::kInternal, "the view could not be made a picture"};
        }
        DORSUM_RETURN_IF_ERROR(WriteFile(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())}));
        return true;
      },
      [this](Result<bool> written) {
        if (!written.ok()) workbench()->Fail(written.error());
      });
}

}  // namespace dorsum
