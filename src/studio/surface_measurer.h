// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "studio/job_runner.h"
#include "studio/surface_measure.h"
#include "studio/surface_scene.h"

namespace dorsum {

// What a person measures on a surface: the chosen places, and the distance or the section between two. No
// widgets.
class SurfaceMeasurer : public QObject {
  Q_OBJECT

 public:
  enum class Mode { kPick, kDistance, kSection };

  explicit SurfaceMeasurer(QObject* parent = nullptr) : QObject(parent) {}

  void SetScan(std::shared_ptr<const Scan> scan);  // may be none; what was measured is gone
  // Two places that are there already are measured the other way at once; else they are gone.
  void SetMode(Mode mode);
  // One more place. It is alone when places are only looked at, or when there were two.
  void Take(const Picked& picked);
  void Clear();

  const std::shared_ptr<const Scan>& scan() const { return scan_; }
  Mode mode() const { return mode_; }
  const std::vector<Picked>& places() const { return places_; }         // one, or two of a measure
  const std::vector<std::uint32_t>& stripe() const { return stripe_; }  // points of the last place's stripe
  const std::optional<SurfaceDistance>& distance() const { return distance_; }
  const std::optional<Section>& section() const { return section_; }
  bool busy() const { return measuring_.busy(); }  // a distance is being measured beside the window
  SceneMarks Marks() const;                        // places, and the way, the section or the stripe

 signals:
  void Changed();  // any of these
  void Failed(const dorsum::Error& error);

 private:
  void Measure();
  void MeasureDistance();
  void Cut();

  std::shared_ptr<const Scan> scan_;
  Mode mode_ = Mode::kPick;
  std::vector<Picked> places_;
  std::vector<std::uint32_t> stripe_;
  std::optional<SurfaceDistance> distance_;
  std::optional<Section> section_;
  JobRunner measuring_;
  bool measure_again_ = false;
};

}  // namespace dorsum
