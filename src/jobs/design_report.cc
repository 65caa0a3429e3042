// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "jobs/design_changes.h"

namespace dorsum {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kCombHeights = 33;
constexpr int kFewStripes = 5;

template <class... Values>
std::string Format(const char* format, Values... values) {
  char text[512];
  const int length = std::snprintf(text, sizeof text, format, values...);
  return {text, static_cast<std::size_t>(std::clamp<int>(length, 0, sizeof text - 1))};
}

// Where the middle of an order's stripe meets a height.
std::optional<Eigen::Vector3d> StripeMiddle(const DesignedLaser& laser, int order, double z) {
  const auto ray = DiffractedRay(laser.fan, order, 0.0);
  if (!ray) return std::nullopt;
  const auto t = Intersect(*ray, {Eigen::Vector3d::UnitZ(), z});
  if (!t) return std::nullopt;
  return ray->At(*t);
}

bool OverHand(const DesignedDevice& device, double x) {
  return x >= device.hand.min().x() && x <= device.hand.max().x();
}

std::vector<OrderFigures> ListOrders(const DesignedDevice& device, double slit_um) {
  const DesignedLaser& laser = device.lasers.front();
  const SlitGrating grating = GratingOf(device.description.grating);
  std::vector<OrderFigures> out;
  for (int m = -laser.Orders(); m <= laser.Orders(); ++m) {
    const auto low = StripeMiddle(laser, m, 0.0);
    const auto high = StripeMiddle(laser, m, device.description.working_heights_mm[1]);
    const auto ray = DiffractedRay(laser.fan, m, 0.0);
    if (!low || !high || !ray) continue;
    OrderFigures o;
    o.order = m;
    o.described = laser.efficiency[static_cast<std::size_t>(std::abs(m))];
    o.slit = RelativeOrderIntensity(grating, slit_um, m);
    o.angle_deg = std::asin(ray->direction.x()) * kDegrees;
    o.low_mm = low->x();
    o.high_mm = high->x();
    o.in_view = OverHand(device, o.low_mm);
    out.push_back(o);
  }
  return out;
}

LaserFigures JudgeLaser(const DesignedDevice& device, int k, const SurfaceAssumption& surface) {
  const DesignedLaser& laser = device.lasers[static_cast<std::size_t>(k)];
  const auto& [low, high] = device.description.working_heights_mm;
  const Eigen::Vector3d middle(device.hand.center().x(), device.hand.center().y(), 0.5 * (low + high));
  const Eigen::Vector3d eye = device.camera.Center();
  LaserFigures out;
  out.x_mm = laser.fan.origin.x();
  out.baseline_mm = std::abs(eye.x() - out.x_mm);
  const double cosine = (eye - middle).normalized().dot((laser.fan.origin - middle).normalized());
  out.triangulation_deg = std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegrees;
  for (int m = -laser.Orders(); m <= laser.Orders(); ++m) {
    const auto at = StripeMiddle(laser, m, 0.0);
    if (at && OverHand(device, at->x())) ++out.stripes_in_view;
  }
  out.volume = JudgeVolume(device, k, surface);
  return out;
}

// "lasers 0 and 1 from 62 to 80 mm" for each stretch of heights at which two combs coincide.
std::vector<std::string> CombWarnings(const std::vector<CombFigures>& combs) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < combs.size(); ++i) {
    if (combs[i].all_coverage == 0.0 || combs[i].closest >= kCombsCoincide) continue;
    std::size_t j = i;
    while (j + 1 < combs.size() && combs[j + 1].all_coverage > 0.0 && combs[j + 1].closest < kCombsCoincide)
      ++j;
    std::size_t worst = i;
    for (std::size_t n = i; n <= j; ++n) {
      if (combs[n].closest < combs[worst].closest) worst = n;
    }
    const CombFigures& w = combs[worst];
    out.push_back(
        Format("from %.0f to %.0f mm high the stripes of lasers %d and %d lie on one another (%.2f of a "
               "spacing apart at %.0f mm), so the two measure the same lines and gaps of %.1f mm stay open",
               combs[i].height_mm, combs[j].height_mm, w.closest_a, w.closest_b, w.closest, w.height_mm,
               w.largest_gap_mm));
    i = j;
  }
  return out;
}

std::vector<std::string> Warn(const DesignReport& r) {
  std::vector<std::string> out = CombWarnings(r.combs);
  const auto& [low, high] = r.device.description.working_heights_mm;
  for (std::size_t k = 0; k < r.lasers.size(); ++k) {
    const VolumeFigures& v = r.lasers[k].volume;
    if (v.used < 0.8) {
      out.push_back(
          Format("laser %d lights, in view, %.0f %% of the volume over the hand area; more orders, a wider "
                 "fan or a wider view would help",
                 static_cast<int>(k), 100.0 * v.used));
    }
    if (v.used > 0.0 && v.narrowest < 8.0) {
      out.push_back(
          Format("stripes of laser %d come within %.1f of their own widths (one standard deviation), so "
                 "neighbours blend; more lines/mm set them further apart",
                 static_cast<int>(k), v.narrowest));
    }
    if (v.used > 0.0 && v.dimmest_peak < 0.03) {
      out.push_back(Format("the dimmest stripe of laser %d reaches %.1f %% of full scale",
                           static_cast<int>(k), 100.0 * v.dimmest_peak));
    }
    if (v.saturated > 0.2) {
      out.push_back(
          Format("stripes of laser %d reach full scale over %.0f %% of what they light; expose less",
                 static_cast<int>(k), 100.0 * v.saturated));
    }
  }
  if (r.ambiguity.joint_mm) {
    out.push_back(
        Format("all lasers together take heights %.0f mm apart for one another: the working volume is "
               "%.0f mm high; set the lasers at uneven distances or the camera nearer to them",
               *r.ambiguity.joint_mm, high - low));
  }
  return out;
}

}  // namespace

std::string ExplainFewOrders(const DesignedDevice& device, int stripes_in_view) {
  if (stripes_in_view >= kFewStripes) return {};
  const GratingDesign& g = device.description.grating;
  const double height = device.description.lasers.front().position_mm.z();
  const double width = device.hand.sizes().x();
  const auto next = OrderSpacing(GratingOf(g), height);
  constexpr double kUsual = 15.0;
  const double lines = std::sin(std::atan(kUsual / height)) / (g.Step() / g.lines_per_mm);
  std::string out = Format(
      "%.0f lines/mm are too many: each order adds wavelength * lines * cos(turn) = %.0f nm * %.0f /mm * "
      "cos(%.0f deg) "
      "= %.3f to the sine of its angle (2.6)",
      g.lines_per_mm, g.wavelength_nm, g.lines_per_mm, g.turn_deg, g.Step());
  if (next) {
    out += Format(", so from %.0f mm up the first order meets the backplane %.0f mm beside the central one",
                  height, *next);
  }
  out += Format(", while the hand area is %.0f mm wide: %d stripe%s of a laser in view. ", width,
                stripes_in_view, stripes_in_view == 1 ? "" : "s");
  out += Format("Stripes %.0f mm apart from that height need %.0f lines/mm at the same wavelength and turn",
                kUsual, lines);
  return out;
}

DesignReport JudgeDesign(const DesignedDevice& device, const SurfaceAssumption& surface) {
  const DeviceDescription& d = device.description;
  const auto& [low, high] = d.working_heights_mm;
  DesignReport r;
  r.device = device;
  r.surface = surface;
  const SlitGrating grating = GratingOf(d.grating);
  r.slit_um = SlitForEvenness(grating, d.grating.orders, d.grating.last_order_efficiency);
  r.slit_brightest_um = SlitForBrightestOrder(grating, d.grating.orders);
  r.orders = ListOrders(device, r.slit_um);
  r.ambiguity = FindAmbiguity(device);
  double row2 = 0.0, pooled2 = 0.0;
  for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
    LaserFigures laser = JudgeLaser(device, k, surface);
    laser.unambiguous_mm = r.ambiguity.single_mm[static_cast<std::size_t>(k)];
    laser.beyond_volume = r.ambiguity.beyond_volume[static_cast<std::size_t>(k)];
    r.points_per_cm2 += laser.volume.points_per_cm2;
    row2 += laser.volume.points_per_cm2 * std::pow(laser.volume.row_sigma_mm, 2);
    pooled2 += laser.volume.points_per_cm2 * std::pow(laser.volume.pooled_sigma_mm, 2);
    r.lasers.push_back(laser);
  }
  if (r.points_per_cm2 > 0.0) {
    r.row_sigma_mm = std::sqrt(row2 / r.points_per_cm2);
    r.pooled_sigma_mm = std::sqrt(pooled2 / r.points_per_cm2);
    if (r.pooled_sigma_mm > 0.0) r.merit = r.points_per_cm2 / r.pooled_sigma_mm;
  }
  r.combs = FindCombs(device, kCombHeights);
  r.seen_low_mm = SeenRectangle(device.camera, low).sizes();
  r.seen_high_mm = SeenRectangle(device.camera, high).sizes();
  const auto px_per_mm = [&](double z) {
    const Eigen::Vector3d at(device.hand.center().x(), device.hand.center().y(), z), x(0.5, 0.0, 0.0);
    return (Project(device.camera, at + x) - Project(device.camera, at - x)).norm();
  };
  r.px_per_mm_low = px_per_mm(low);
  r.px_per_mm_high = px_per_mm(high);
  r.warnings = Warn(r);
  const std::string why = ExplainFewOrders(device, r.lasers.front().stripes_in_view);
  if (!why.empty()) r.explanations.push_back(why);
  return r;
}

}  // namespace dorsum
