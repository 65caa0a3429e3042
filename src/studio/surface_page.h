// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "studio/page.h"
#include "studio/surface_measurer.h"

class QLabel;

namespace dorsum {

class ScaleBar;
class SectionPlot;
class SurfaceControls;
class SurfaceFiles;
class SurfaceImage;
class SurfaceView;

// Looks at the scan of the workbench: its surface, the image that it came from, and what a person measures
// on it.
class SurfacePage : public Page {
  Q_OBJECT

 public:
  using Mode = SurfaceMeasurer::Mode;

  SurfacePage(Workbench* workbench, QWidget* parent);

  // Writes the surface, or the picture of the view for .png, beside the window.
  void ExportTo(const std::filesystem::path& path);
  // The surface of another PLY file, to be compared with; read beside the window.
  void CompareWith(const std::filesystem::path& path);
  void Take(const Picked& picked);  // what a person pointed at
  void SetMode(Mode mode) { measurer_.SetMode(mode); }

  bool busy() const { return building_.busy() || measurer_.busy(); }
  const std::vector<Picked>& places() const { return measurer_.places(); }
  const std::optional<SurfaceDistance>& distance() const { return measurer_.distance(); }
  const std::optional<Section>& section() const { return measurer_.section(); }

 private:
  void NameWidgets();
  void ArrangeWidgets();
  void ConnectControls();
  void ScanChanged();
  void Rebuild();
  void Built(std::shared_ptr<const SceneBuffers> buffers);
  void ShowMeasure();
  void Say();

  std::shared_ptr<const Scan> scan_;
  std::shared_ptr<const OtherHeight> other_;
  QString other_name_;
  JobRunner building_;
  bool build_again_ = false, frame_ = true;
  std::shared_ptr<const SceneBuffers> buffers_;
  SurfaceMeasurer measurer_;

  SurfaceControls* controls_;
  SurfaceFiles* files_;
  SurfaceView* view_;
  SurfaceImage* image_;
  SectionPlot* plot_;
  ScaleBar* scale_;
  QLabel *empty_, *readout_;
};

}  // namespace dorsum
