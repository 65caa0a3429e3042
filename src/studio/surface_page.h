// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "studio/page.h"
#include "studio/surface_measure.h"
#include "studio/surface_scene.h"

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSplitter;

namespace dorsum {

class ImageView;
class ScaleBar;
class SectionPlot;
class SurfaceView;

// Looks at the scan of the workbench: its surface, the image that it came from, and what a person measures
// on it.
class SurfacePage : public Page {
  Q_OBJECT

 public:
  enum class Mode { kPick, kDistance, kSection };

  SurfacePage(Workbench* workbench, QWidget* parent);

  // Writes the surface, or the picture of the view for .png, beside the window.
  void ExportTo(const std::filesystem::path& path);
  // The surface of another PLY file, to be compared with; read beside the window.
  void CompareWith(const std::filesystem::path& path);
  void Take(const Picked& picked);  // what a person pointed at
  void SetMode(Mode mode);

  bool busy() const { return building_.busy() || measuring_.busy(); }
  const std::vector<Picked>& places() const { return places_; }
  const std::optional<SurfaceDistance>& distance() const { return distance_; }
  const std::optional<Section>& section() const { return section_; }

 private:
  QWidget* MakeControls();
  QWidget* MakeImageSide();
  void AddModes(QHBoxLayout* row);
  void RememberChoices();
  void ScanChanged();
  void Rebuild();
  void Built(std::shared_ptr<const SceneBuffers> buffers);
  void ShowImage();
  void AimedAtImage(const QPointF& pixel, double reach_px);
  void Highlight(std::optional<std::uint32_t> point);
  void Measure();
  void MeasureDistance();
  void Cut();
  void Clear();
  void ShowMarks();
  void Say();
  QString PlaceText(const Picked& picked) const;
  QString MeasureText() const;
  Shown shown() const;
  std::optional<int> laser() const;  // whose image is shown

  std::shared_ptr<const Scan> scan_;
  std::shared_ptr<const OtherHeight> other_;
  QString other_name_;
  JobRunner building_, measuring_;
  bool build_again_ = false, measure_again_ = false, frame_ = true;
  std::shared_ptr<const SceneBuffers> buffers_;

  int wished_show_ = 0, wished_colours_ = 0;  // as the person chose last; not every surface has them

  Mode mode_ = Mode::kPick;
  std::vector<Picked> places_;                // one, or two of a measure
  std::vector<Eigen::Vector3d> stripe_dots_;  // of the highlighted stripe
  std::optional<SurfaceDistance> distance_;
  std::optional<Section> section_;

  SurfaceView* view_;
  ImageView* image_;
  SectionPlot* plot_;
  ScaleBar* scale_;
  QComboBox *show_, *colours_, *images_;
  QLabel *empty_, *readout_;
  QButtonGroup* modes_;
  QPushButton *compare_, *export_, *clear_;
};

}  // namespace dorsum
