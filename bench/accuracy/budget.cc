// SPDX-License-Identifier: Apache-2.0
#include "accuracy/budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "accuracy/object_area.h"
#include "accuracy/stripe_match.h"
#include "surface/height_field.h"
#include "surface/height_mesh.h"
#include "surface/robust_fusion.h"
#include "surface/triangulation.h"

namespace dorsum::accuracy {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPointStepMm = 1.5, kStrayPx = 3.0, kLitIrradiance = 0.02;

// An image point with the order that it is taken for.
struct Sighting {
  int laser, order;
  double u, v;
};

// The product's triangulation of single image points; NaN where it gives none.
std::vector<double> HeightsOf(const std::vector<Sighting>& sightings, const DeviceGeometry& device,
                              const TriangulationOptions& options, const Context& context) {
  IndexedStripes stripes;
  std::map<int, std::vector<std::size_t>> by_laser;
  for (std::size_t i = 0; i < sightings.size(); ++i) by_laser[sightings[i].laser].push_back(i);
  for (const auto& [laser, indices] : by_laser) {
    LaserStripes one;
    one.laser = laser;
    for (const std::size_t i : indices) {  // each a segment of its own, so that it can be found again
      StripePoint p;
      p.u = static_cast<float>(sightings[i].u);
      p.v = static_cast<float>(sightings[i].v);
      p.segment = static_cast<std::int32_t>(one.segments.size());
      StripeSegment segment;
      segment.first = static_cast<std::int32_t>(one.points.size());
      segment.count = 1;
      segment.order = sightings[i].order;
      one.points.push_back(p);
      one.segments.push_back(segment);
    }
    stripes.lasers.push_back(std::move(one));
  }
  std::vector<double> heights(sightings.size(), kNan);
  for (const SurfacePoint& p : Triangulate(stripes, DeviceOrders(device), options, context).points) {
    heights[by_laser[p.laser][static_cast<std::size_t>(p.segment)]] = p.position.z();
  }
  return heights;
}

// Errors of one point, mm; those of stages are NaN where they cannot be told apart.
struct PointErrors {
  double total = 0.0, plane = kNan, ridge = kNan, index = kNan;
  bool stray = false;
};

// A calibration may count a laser's orders from another stripe than the truth does: by how many, as most of
// the points that are right have it.
std::map<int, int> OrderShifts(const CaptureTruth& truth, const SurfacePoints& points) {
  constexpr double kRightMm = 2.0;
  std::map<int, std::vector<double>> differences;
  for (const SurfacePoint& p : points) {
    const TrueStripe* stripe = NearestStripe(truth, p);
    if (stripe == nullptr || std::abs(stripe->u - p.u) > kStrayPx) continue;
    if (std::abs(p.position.z() - stripe->z) < kRightMm)
      differences[p.laser].push_back(p.order - stripe->order);
  }
  std::map<int, int> shifts;
  for (const auto& [laser, list] : differences)
    shifts[laser] = static_cast<int>(std::lround(Quantile(list, 0.5)));
  return shifts;
}

std::vector<PointErrors> Separate(const CaptureTruth& truth, const DeviceGeometry& true_device,
                                  const DeviceGeometry& calibrated, const TriangulationOptions& triangulation,
                                  const SurfacePoints& points, const Context& context) {
  std::vector<PointErrors> errors;
  std::map<int, int> shifts = OrderShifts(truth, points);
  std::vector<std::size_t> matched;                               // of `errors`
  std::vector<Sighting> at_truth, at_measurement, truly_counted;  // all of the true order
  std::vector<double> true_at_stripe, true_at_point, given;
  for (const SurfacePoint& p : points) {
    const double z = TruthAt(truth, p.u, p.v, kPointStepMm)[2];
    if (std::isnan(z)) continue;
    errors.push_back({p.position.z() - z});
    const TrueStripe* stripe = NearestStripe(truth, p);
    errors.back().stray = stripe == nullptr || std::abs(stripe->u - p.u) > kStrayPx;
    if (errors.back().stray) continue;
    matched.push_back(errors.size() - 1);
    const int counted = stripe->order + shifts[p.laser];
    at_truth.push_back({p.laser, counted, stripe->u, static_cast<double>(p.v)});
    at_measurement.push_back({p.laser, counted, p.u, p.v});
    truly_counted.push_back({p.laser, stripe->order, p.u, p.v});
    true_at_stripe.push_back(stripe->z);
    true_at_point.push_back(z);
    given.push_back(p.position.z());
  }
  const TriangulationOptions truly{.sheets = SheetModel::kCone, .correction = false};
  const std::vector<double> plane = HeightsOf(at_truth, calibrated, triangulation, context);
  const std::vector<double> ridge = HeightsOf(truly_counted, true_device, truly, context);
  const std::vector<double> right = HeightsOf(at_measurement, calibrated, triangulation, context);
  for (std::size_t i = 0; i < matched.size(); ++i) {
    PointErrors& e = errors[matched[i]];
    e.plane = plane[i] - true_at_stripe[i];
    e.ridge = ridge[i] - true_at_point[i];
    e.index = given[i] - right[i];
  }
  return errors;
}

// rms over all points; a part that is not known counts as none.
template <class Part>
double RmsOf(const std::vector<PointErrors>& errors, const Part& part) {
  std::vector<double> values;
  for (const PointErrors& e : errors) {
    const double value = part(e);
    values.push_back(std::isnan(value) ? 0.0 : value);
  }
  return Rms(values);
}

// The true stripe points of the object as a reconstruction without any error would give them.
SurfacePoints TruePoints(const CaptureTruth& truth, float sigma) {
  SurfacePoints points;
  for (const auto& [laser, stripes] : truth.lasers) {
    for (const TrueStripe& s : stripes) {
      if (!(s.irradiance > kLitIrradiance) || !CaptureTruth::IsObject(s.material)) continue;
      SurfacePoint p;
      const Ray ray = CastRay(truth.camera, {s.u, static_cast<double>(s.row)});
      p.position = ray.At((s.z - ray.origin.z()) / ray.direction.z());
      p.laser = static_cast<std::uint8_t>(laser);
      p.order = static_cast<std::int16_t>(s.order);
      p.u = static_cast<float>(s.u);
      p.v = static_cast<float>(s.row);
      p.sigma = sigma;
      p.segment = s.order;
      points.push_back(p);
    }
  }
  // Along each stripe, as stripes are followed.
  std::stable_sort(points.begin(), points.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return std::tie(a.laser, a.order) < std::tie(b.laser, b.order);
  });
  return points;
}

}  // namespace

Figures ErrorBudget(const CaptureTruth& truth, const DeviceGeometry& true_device,
                    const DeviceGeometry& calibrated, const ReconstructOptions& options,
                    const SurfacePoints& points, const Context& context) {
  const TriangulationOptions triangulation{
      .sheets = options.sheets == "cone" ? SheetModel::kCone : SheetModel::kPlane,
      .correction = options.correction == "polynomial"};
  const std::vector<PointErrors> errors =
      Separate(truth, true_device, calibrated, triangulation, points, context);
  Figures f;
  f["total"] = RmsOf(errors, [](const PointErrors& e) { return e.total; });
  f["plane"] = RmsOf(errors, [](const PointErrors& e) { return e.plane; });
  f["ridge"] = RmsOf(errors, [](const PointErrors& e) { return e.ridge; });
  f["index"] = RmsOf(errors, [](const PointErrors& e) { return e.index; });
  f["stray"] = RmsOf(errors, [](const PointErrors& e) { return e.stray ? e.total : 0.0; });
  const auto known = [](double part) { return std::isnan(part) ? 0.0 : part; };
  f["without_plane"] = RmsOf(errors, [&](const PointErrors& e) { return e.total - known(e.plane); });
  f["without_ridge"] = RmsOf(errors, [&](const PointErrors& e) { return e.total - known(e.ridge); });
  f["without_index"] = RmsOf(errors, [&](const PointErrors& e) { return e.total - known(e.index); });
  f["without_stray"] = RmsOf(errors, [](const PointErrors& e) { return e.stray ? 0.0 : e.total; });

  constexpr float kTypicalSigmaMm = 0.05F;
  const SurfacePoints perfect = TruePoints(truth, kTypicalSigmaMm);
  const cv::Mat1b outline = ObjectArea(truth, 0) * 255;
  const TriangleMesh mesh =
      options.fusion == "robust"
          ? FuseRobust(perfect, truth.camera, outline, options.robust_fusion, context).mesh
          : MeshHeightField(FuseHeightField(perfect, truth.camera, outline, options.height_field, context));
  if (const auto surface = ScoreSurface(truth, mesh, {})) {
    f["fusion"] = surface->z.rmse;
    f["fusion_median_abs"] = surface->z.median_abs;
    f["fusion_p95_abs"] = surface->z.p95_abs;
    f["fusion_cover"] = surface->cover;
    f["fusion_beyond"] = surface->beyond;
  }
  return f;
}

}  // namespace dorsum::accuracy
