// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_measurer.h"

#include <algorithm>
#include <utility>

namespace dorsum {
namespace {

constexpr double kSectionReach_mm = 0.5;  // of points beside the plane, where there is no mesh
constexpr double kDot_mm = 0.25;          // between the dots of a line

void AppendLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, std::vector<Eigen::Vector3d>* dots) {
  const int steps = std::min(2000, 1 + static_cast<int>((b - a).norm() / kDot_mm));
  for (int i = 0; i <= steps; ++i) dots->emplace_back(a + (b - a) * (static_cast<double>(i) / steps));
}

// A section's curves and dots in the world, over the line from `a` through `b`.
void AppendSection(const Section& section, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   std::vector<Eigen::Vector3d>* dots) {
  const Eigen::Vector2d along = (b - a).head<2>().normalized();
  const auto at = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector3d(a.x() + p.x() * along.x(), a.y() + p.x() * along.y(), p.y());
  };
  for (const SectionCurve& curve : section.curves) {
    for (std::size_t i = 1; i < curve.size(); ++i) AppendLine(at(curve[i - 1]), at(curve[i]), dots);
  }
  for (const Eigen::Vector2d& p : section.dots) dots->push_back(at(p));
}

}  // namespace

void SurfaceMeasurer::SetScan(std::shared_ptr<const Scan> scan) {
  scan_ = std::move(scan);
  Clear();
}

void SurfaceMeasurer::SetMode(Mode mode) {
  mode_ = mode;
  if (places_.size() != 2 || mode == Mode::kPick) return Clear();
  Measure();
  emit Changed();
}

void SurfaceMeasurer::Take(const Picked& picked) {
  if (mode_ == Mode::kPick || places_.size() >= 2) Clear();
  places_.push_back(picked);
  stripe_.clear();
  if (picked.point) {
    const SurfacePoints& points = scan_->surface.points;
    stripe_ = PointsOfStripe(points, KeyOf(points[*picked.point]));
  }
  if (places_.size() == 2) Measure();
  emit Changed();
}

void SurfaceMeasurer::Clear() {
  measuring_.Cancel();
  places_.clear();
  stripe_.clear();
  distance_.reset();
  section_.reset();
  emit Changed();
}

void SurfaceMeasurer::Measure() {
  distance_.reset();
  section_.reset();
  if (mode_ == Mode::kSection) return Cut();
  if (mode_ == Mode::kDistance) MeasureDistance();
}

void SurfaceMeasurer::Cut() {
  const Reconstruction& surface = scan_->surface;
  Result<Section> section = Section{};
  if (surface.mesh.faces.empty()) {
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePoint& p : surface.points) points.push_back(p.position);
    section = CutPoints(points, places_[0].position, places_[1].position, kSectionReach_mm);
  } else {
    section = CutMesh(surface.mesh, places_[0].position, places_[1].position);
  }
  if (!section.ok()) return emit Failed(section.error());
  section_ = *section;
}

void SurfaceMeasurer::MeasureDistance() {
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
        if (!distance.ok()) return emit Failed(distance.error());
        distance_ = *distance;
        emit Changed();
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

SceneMarks SurfaceMeasurer::Marks() const {
  SceneMarks marks;
  for (const Picked& picked : places_) marks.places.push_back(picked.position);
  if (distance_) {
    for (std::size_t i = 1; i < distance_->path.size(); ++i) {
      AppendLine(distance_->path[i - 1], distance_->path[i], &marks.line);
    }
  } else if (section_ && places_.size() == 2) {
    AppendSection(*section_, places_[0].position, places_[1].position, &marks.line);
  } else {
    for (const std::uint32_t i : stripe_) marks.line.push_back(scan_->surface.points[i].position);
  }
  return marks;
}

}  // namespace dorsum
