// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "studio/surface_measurer.h"

class QComboBox;

namespace dorsum {

class ImageView;

// The images that a surface came from, with their stripes; one is chosen. A place of a stripe is a place of
// the surface.
class SurfaceImage : public QWidget {
  Q_OBJECT

 public:
  explicit SurfaceImage(QWidget* parent = nullptr);

  void SetScan(std::shared_ptr<const Scan> scan);
  // The image of this point's laser, unless that of all stripes is shown.
  void ShowLaserOf(const SurfacePoint& point);
  void Highlight(const SurfaceMeasurer& measured);  // the last place, and its stripe

 signals:
  void Aimed(const dorsum::Picked& picked);

 private:
  void ShowImage();
  void AimedAt(const QPointF& pixel, double reach_px);
  std::optional<int> laser() const;  // whose image is shown

  std::shared_ptr<const Scan> scan_;
  ImageView* image_;
  QComboBox* images_;
};

}  // namespace dorsum
