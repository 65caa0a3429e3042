// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_readout.h"

#include <QStringList>

#include "studio/surface_page.h"

namespace dorsum {
namespace {

using Mode = SurfaceMeasurer::Mode;

QString ScanText(const Scan& scan) {
  return SurfacePage::tr("%1: %2, %3")
      .arg(QString::fromStdString(scan.name),
           SurfacePage::tr("%Ln point(s)", "", static_cast<int>(scan.surface.points.size())),
           SurfacePage::tr("%Ln triangle(s)", "", static_cast<int>(scan.surface.mesh.faces.size())));
}

QString PlaceText(const Scan& scan, const Picked& picked) {
  const Eigen::Vector3d& p = picked.position;
  QString text = SurfacePage::tr("x %1, y %2, z %3 mm")
                     .arg(p.x(), 0, 'f', 2)
                     .arg(p.y(), 0, 'f', 2)
                     .arg(p.z(), 0, 'f', 2);
  if (picked.image) {
    text += SurfacePage::tr("; image %1, %2 px")
                .arg(picked.image->x(), 0, 'f', 1)
                .arg(picked.image->y(), 0, 'f', 1);
  }
  if (picked.point) {
    const SurfacePoint& point = scan.surface.points[*picked.point];
    text += SurfacePage::tr("; stripe of laser %1, order %2").arg(point.laser).arg(point.order);
    if (point.sigma > 0.0F) {
      text += SurfacePage::tr("; one standard deviation of z %1 mm").arg(point.sigma, 0, 'f', 3);
    }
  }
  return text;
}

QString MeasureText(const SurfaceMeasurer& measurer) {
  const auto& places = measurer.places();
  const double straight = (places[1].position - places[0].position).norm();
  QString text = SurfacePage::tr("Straight %1 mm").arg(straight, 0, 'f', 2);
  if (measurer.distance()) {
    text += SurfacePage::tr(", along the surface %1 mm").arg(measurer.distance()->along_mm, 0, 'f', 2);
  }
  if (measurer.mode() == Mode::kDistance && measurer.scan()->surface.mesh.faces.empty()) {
    text += SurfacePage::tr("; points alone have no way along a surface");
  } else if (measurer.mode() == Mode::kDistance && measurer.busy() && !measurer.distance()) {
    text += SurfacePage::tr(", measuring along the surface…");
  }
  return text;
}

QString DifferenceText(const DifferenceSummary& d, const QString& other) {
  return SurfacePage::tr("Against %1: mean %2 mm, RMS %3 mm; places compared: %L4, outside it: %L5")
      .arg(other)
      .arg(d.mean_mm, 0, 'f', 3)
      .arg(d.rms_mm, 0, 'f', 3)
      .arg(d.compared)
      .arg(d.outside);
}

}  // namespace

QString SurfaceReadout(const SurfaceMeasurer& measurer, const DifferenceSummary* difference,
                       const QString& other) {
  const auto& places = measurer.places();
  if (!measurer.scan()) return {};
  QStringList lines;
  if (places.empty()) {
    lines << ScanText(*measurer.scan());
    if (measurer.mode() == Mode::kPick) {
      lines << SurfacePage::tr("Click a place of the surface or a stripe of the image.");
    }
  }
  if (measurer.mode() != Mode::kPick && places.size() < 2) {
    lines << (places.empty() ? SurfacePage::tr("Click the first of two places.")
                             : SurfacePage::tr("Click the second place."));
  }
  if (places.size() >= 2) lines << MeasureText(measurer);
  for (const Picked& picked : places) lines << PlaceText(*measurer.scan(), picked);
  if (difference != nullptr) lines << DifferenceText(*difference, other);
  return lines.join('\n');
}

}  // namespace dorsum
