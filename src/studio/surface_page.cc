// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_page.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "studio/named_widget.h"
#include "studio/scale_bar.h"
#include "studio/section_plot.h"
#include "studio/surface_controls.h"
#include "studio/surface_files.h"
#include "studio/surface_image.h"
#include "studio/surface_readout.h"
#include "studio/surface_view.h"

namespace dorsum {

SurfacePage::SurfacePage(Workbench* workbench, QWidget* parent)
    : Page(workbench, parent),
      controls_(new SurfaceControls(this)),
      files_(new SurfaceFiles(workbench, this)),
      view_(new SurfaceView(this)),
      image_(new SurfaceImage(this)),
      plot_(new SectionPlot(this)),
      scale_(new ScaleBar(this)),
      empty_(new QLabel(this)),
      readout_(new QLabel(this)) {
  NameWidgets();
  ArrangeWidgets();
  ConnectControls();
  connect(workbench, &Workbench::ScanChanged, this, &SurfacePage::ScanChanged);
  connect(view_, &SurfaceView::Aimed, this, [this](const Ray& ray, double slope) {
    if (!scan_) return;
    const std::optional<Picked> picked = Pick(*scan_, ray, controls_->shown(), slope);
    if (picked) Take(*picked);
  });
  connect(view_, &SurfaceView::Unavailable, this, [this](const QString& why) {
    this->workbench()->Fail(Error{ErrorCode::kInternal, why.toStdString()});
  });
  connect(image_, &SurfaceImage::Aimed, this, &SurfacePage::Take);
  connect(&measurer_, &SurfaceMeasurer::Changed, this, &SurfacePage::ShowMeasure);
  connect(&measurer_, &SurfaceMeasurer::Failed, workbench, &Workbench::Fail);
  ScanChanged();
}

void SurfacePage::NameWidgets() {
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
}

void SurfacePage::ArrangeWidgets() {
  auto* left = new QWidget(this);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(empty_, 1);
  column->addWidget(view_, 1);
  column->addWidget(scale_);
  column->addWidget(readout_);
  auto* side = new QSplitter(Qt::Vertical, this);
  side->setObjectName("surfaceSide");
  side->addWidget(image_);
  side->addWidget(plot_);
  auto* split = new QSplitter(this);
  split->setObjectName("surfaceSplit");
  split->addWidget(left);
  split->addWidget(side);
  for (QSplitter* splitter : {side, split}) {
    splitter->setChildrenCollapsible(false);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
  }
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(controls_);
  all->addWidget(split, 1);
}

void SurfacePage::ConnectControls() {
  connect(controls_, &SurfaceControls::ShownChanged, this, [this] { view_->SetShown(controls_->shown()); });
  connect(controls_, &SurfaceControls::ColoursChanged, this, &SurfacePage::Rebuild);
  connect(controls_, &SurfaceControls::ModeChosen, this, &SurfacePage::SetMode);
  connect(controls_, &SurfaceControls::ClearWanted, this, [this] { measurer_.Clear(); });
  connect(controls_, &SurfaceControls::CompareWanted, this, [this] {
    const std::filesystem::path path = SurfaceFiles::AskForOther(this);
    if (!path.empty()) CompareWith(path);
  });
  connect(controls_, &SurfaceControls::ExportWanted, this, [this] {
    const std::filesystem::path path = SurfaceFiles::AskWhereTo(!scan_->surface.mesh.faces.empty(), this);
    if (!path.empty()) ExportTo(path);
  });
  connect(files_, &SurfaceFiles::HasOther, this,
          [this](std::shared_ptr<const OtherHeight> other, const QString& name) {
            other_ = std::move(other);
            other_name_ = name;
            controls_->ChooseDifference(name);
          });
}

void SurfacePage::ExportTo(const std::filesystem::path& path) {
  files_->Export(path, scan_ && path.extension() == ".png" ? view_->Picture() : QImage());
}

void SurfacePage::CompareWith(const std::filesystem::path& path) { files_->ReadOther(path); }

void SurfacePage::ScanChanged() {
  scan_ = workbench()->scan();
  const bool mesh = scan_ && !scan_->surface.mesh.faces.empty();
  const bool points = scan_ && !scan_->surface.points.empty();
  empty_->setVisible(!mesh && !points);
  view_->setVisible(mesh || points);
  scale_->setVisible(mesh || points);
  controls_->Offer(mesh, points, other_ != nullptr);
  view_->SetShown(controls_->shown());
  frame_ = true;
  image_->SetScan(scan_);
  measurer_.SetScan(scan_);
  Rebuild();
}

void SurfacePage::Rebuild() {
  build_again_ = building_.busy();
  if (build_again_ || !scan_) return;
  building_.Run<std::shared_ptr<const SceneBuffers>>(
      tr("Colouring the surface"),
      [scan = scan_, by = controls_->colours(),
       other = other_](const Context&) -> Result<std::shared_ptr<const SceneBuffers>> {
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

void SurfacePage::Take(const Picked& picked) {
  if (picked.point) image_->ShowLaserOf(scan_->surface.points[*picked.point]);
  measurer_.Take(picked);
}

void SurfacePage::ShowMeasure() {
  controls_->ShowState(measurer_);
  plot_->SetSection(section().value_or(Section()));
  image_->Highlight(measurer_);
  view_->SetMarks(measurer_.Marks());
  Say();
}

void SurfacePage::Say() {
  const bool compared = buffers_ && buffers_->scale.by == ColourBy::kDifference;
  readout_->setText(SurfaceReadout(measurer_, compared ? &buffers_->difference : nullptr, other_name_));
}

}  // namespace dorsum
