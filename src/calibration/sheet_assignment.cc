// SPDX-License-Identifier: Apache-2.0
#include "calibration/sheet_assignment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/parallel.h"
#include "calibration/stripe_models.h"

namespace dorsum {
namespace {

struct Fit {
  int plane = 0, order = 0;
  double miss = 1e9;  // median, orders
};

class Assigner {
 public:
  Assigner(const BundleState& state, const SheetAssignmentOptions& options)
      : models_(state), options_(options) {}

  void AddPicture(const SheetPicture& picture, int source, std::vector<SheetPoint>* out) const {
    for (const StripeSegment& segment : picture.stripes.segments) {
      if (segment.count <= 2 * options_.end_rows) continue;
      std::vector<Fit> fits;
      fits.reserve(picture.planes.size());
      for (const int plane : picture.planes) fits.push_back(FitPlane(picture, segment, plane));
      const Fit* chosen = Choose(fits, picture.planes.front() == 1);
      if (chosen == nullptr) continue;
      AddPoints(picture, segment, source, *chosen, out);
    }
  }

 private:
  Fit FitPlane(const SheetPicture& picture, const StripeSegment& segment, int plane) const {
    Fit fit;
    fit.plane = plane;
    const StripeModel& model = models_.Of(picture.laser, plane);
    StripeSearch search;
    std::vector<double> orders;
    // The rows that become points say it best; short segments have too few of them.
    constexpr int kEnough = 4, kMost = 40;
    const bool few = segment.count < options_.end_rows + kEnough * options_.every_rows;
    const int from = few ? 0 : options_.end_rows;
    const int step = few ? std::max(1, segment.count / kMost) : options_.every_rows;
    for (std::int32_t i = segment.first + from; i < segment.first + segment.count; i += step) {
      const StripePoint& p = picture.stripes.points[static_cast<std::size_t>(i)];
      orders.push_back(model.Order({p.u, p.v}, &search));
    }
    const auto middle = orders.begin() + static_cast<std::ptrdiff_t>(orders.size() / 2);
    std::nth_element(orders.begin(), middle, orders.end());
    if (!std::isfinite(*middle)) return fit;
    fit.order = static_cast<int>(std::lround(*middle));
    for (double& o : orders) o = std::abs(o - fit.order);
    std::nth_element(orders.begin(), middle, orders.end());
    fit.miss = *middle;
    return fit;
  }

  // The calibration object is put so that it fills the picture; a box never does.
  const Fit* Choose(const std::vector<Fit>& fits, bool expected_fills) const {
    const Fit* best = &fits.front();
    const Fit* other = nullptr;
    for (std::size_t i = 1; i < fits.size(); ++i) {
      if (fits[i].miss < best->miss) {
        other = best;
        best = &fits[i];
      } else if (other == nullptr || fits[i].miss < other->miss) {
        other = &fits[i];
      }
    }
    const bool clear = other == nullptr || other->miss > options_.clear * best->miss + 0.02;
    if (!clear && expected_fills) best = &fits.front();
    if (best->miss > options_.tolerance || (!clear && !expected_fills)) return nullptr;
    return best;
  }

  void AddPoints(const SheetPicture& picture, const StripeSegment& segment, int source, const Fit& fit,
                 std::vector<SheetPoint>* out) const {
    const StripeModel& model = models_.Of(picture.laser, fit.plane);
    const std::int32_t end = segment.first + segment.count - options_.end_rows;
    for (std::int32_t i = segment.first + options_.end_rows; i < end; i += options_.every_rows) {
      const StripePoint& p = picture.stripes.points[static_cast<std::size_t>(i)];
      SheetPoint point;
      point.laser = picture.laser;
      point.source = source;
      point.plane = fit.plane;
      point.order = fit.order;
      point.u = p.u;
      point.v = p.v;
      point.sd_px = p.sd_px;
      point.peak = p.peak;
      const StripeModel::Along along = model.OrderAlong({p.u, p.v});
      if (!(std::abs(along.order - fit.order) <= options_.tolerance)) continue;
      point.orders_per_px = along.orders_per_px;
      point.mm_per_px = along.mm_per_px;
      if (point.orders_per_px > 0.0 && std::isfinite(point.orders_per_px)) out->push_back(point);
    }
  }

  const StripeModels models_;
  const SheetAssignmentOptions& options_;
};

}  // namespace

std::vector<SheetPoint> AssignOrders(const std::vector<SheetPicture>& pictures, const BundleState& state,
                                     const SheetAssignmentOptions& options, const Context& context) {
  const Assigner assigner(state, options);
  std::vector<std::vector<SheetPoint>> of_pictures(pictures.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(pictures.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    assigner.AddPicture(pictures[k], static_cast<int>(i), &of_pictures[k]);
  });
  std::vector<SheetPoint> points;
  for (const auto& own : of_pictures) points.insert(points.end(), own.begin(), own.end());
  return points;
}

}  // namespace dorsum
