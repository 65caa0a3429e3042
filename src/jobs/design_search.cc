// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "jobs/design_ambiguity.h"
#include "jobs/design_changes.h"
#include "jobs/design_combs.h"
#include "jobs/design_field.h"
#include "jobs/design_report.h"

namespace dorsum {
namespace {

constexpr double kBaselineStepMm = 10.0, kCameraStepMm = 5.0;

std::string Figure(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::vector<double> Gratings(const DesignSearch& search) {
  std::vector<double> lines = search.gratings;
  if (search.grating_range.size() == 2) {
    for (double n = search.grating_range[0]; n <= search.grating_range[1] * (1.0 + 1e-9); n *= 1.05)
      lines.push_back(std::round(n));
  }
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

// Orders that reach the hand area's rim at the volume's top, where they spread least; 0 where the grating's
// angles do not suffice.
int OrdersNeeded(const DeviceDescription& d, const Eigen::Vector2d& hand_mm) {
  double outermost = 0.0, height = 1e9;
  for (const LaserDesign& laser : d.lasers) {
    outermost = std::max(outermost, std::abs(laser.position_mm.x() - MiddleOfLasers(d)));
    height = std::min(height, laser.position_mm.z());
  }
  const double reach = 0.5 * hand_mm.x() + outermost;
  const double alpha = std::sin(std::atan(reach / (height - d.working_heights_mm[1])));
  const int needed = static_cast<int>(std::ceil(alpha / d.grating.Step() - 0.5));
  return needed > MostOrders(d.grating) ? 0 : std::max(1, needed);
}

// The camera at this baseline, as low as the picture's size allows, looking at the middle of the lasers; none
// where no height within the limits shows the hand area.
std::optional<DesignedDevice> PlaceCamera(DeviceDescription d, double baseline_mm,
                                          const Eigen::Vector2d& hand_mm, const DesignSearch& search) {
  const double side = d.camera.position_mm.x() > MiddleOfLasers(d) ? 1.0 : -1.0;
  d.camera.position_mm.x() = MiddleOfLasers(d) + side * baseline_mm;
  d.camera.position_mm.y() = d.camera.look_at_mm.y() = 0.0;
  d.camera.look_at_mm.z() = 0.0;
  for (double height = search.camera_heights_mm[0]; height <= search.camera_heights_mm[1];
       height += kCameraStepMm) {
    d.camera.position_mm.z() = height;
    d.camera.look_at_mm.x() = MiddleOfLasers(d);
    for (int i = 0; i < 3; ++i) {  // an oblique view of two heights has its middle a little beside the target
      const auto device = LayOutDevice(d, hand_mm);
      if (!device.ok()) break;
      const double off = device->hand.center().x() - MiddleOfLasers(d);
      if (std::abs(off) < 0.5) {
        const auto& [low, high] = d.working_heights_mm;
        const Eigen::AlignedBox2d seen =
            SeenRectangle(device->camera, low).intersection(SeenRectangle(device->camera, high));
        if (seen.contains(device->hand)) return *device;
        break;
      }
      d.camera.look_at_mm.x() -= off;
    }
  }
  return std::nullopt;
}

// Whether the camera, a box of 60 mm, stands in light that is on its way to the hand area.
bool StandsInTheLight(const DesignedDevice& device) {
  constexpr double kHalfCameraMm = 30.0;
  const Eigen::Vector3d eye = device.camera.Center();
  const double high = device.description.working_heights_mm[1];
  for (const DesignedLaser& laser : device.lasers) {
    const Eigen::Vector3d from = laser.fan.origin;
    if (eye.z() >= from.z()) continue;
    const double share = (from.z() - eye.z()) / (from.z() - high);
    for (const double rim : {device.hand.min().x(), device.hand.max().x()}) {
      const double at = from.x() + share * (rim - from.x());
      const bool same_side = (rim - from.x()) * (eye.x() - from.x()) > 0.0;
      if (same_side && std::abs(eye.x() - from.x()) < std::abs(at - from.x()) + kHalfCameraMm) return true;
    }
  }
  return false;
}

// The device behind this grating, but for the camera.
std::optional<DeviceDescription> WithGrating(DeviceDescription d, double lines,
                                             const Eigen::Vector2d& hand_mm, const DesignSearch& search,
                                             std::string* why) {
  d.grating.lines_per_mm = lines;
  if (MostOrders(d.grating) < 1) {
    *why = "sends no order but the central one into view";
    return std::nullopt;
  }
  const int count = static_cast<int>(d.lasers.size());
  PlaceLasers(count, BestPitch(d, search.least_pitch_mm), 0.0, &d.lasers);
  const int orders = OrdersNeeded(d, hand_mm);
  if (orders == 0) {
    *why = "needs more orders than there are, or than can be counted, to reach the hand area's rim";
    return std::nullopt;
  }
  const double across = 2.0 * orders + 1.0;
  if (across < 5.0) {
    *why = "gives at most " + Figure(across, 0) + " stripes of a laser: the first order lies " +
           Figure(OrderSpacing(GratingOf(d.grating), d.lasers.front().position_mm.z()).value_or(0.0), 0) +
           " mm beside the central one";
    return std::nullopt;
  }
  d.grating.orders = orders;
  SetSlit(SlitForBrightestOrder(GratingOf(d.grating), orders), &d.grating);
  for (LaserDesign& laser : d.lasers) {
    // Wide enough for the hand's length along the stripe at the volume's top, and 10 mm more on each side.
    const double opening =
        std::atan((0.5 * hand_mm.y() + 10.0) / (laser.position_mm.z() - d.working_heights_mm[1]));
    laser.half_angle_deg = std::clamp(std::ceil(opening * 180.0 / std::numbers::pi), 1.0, 60.0);
  }
  return d;
}

SearchHit Judge(const DesignedDevice& device, double baseline_mm, const SurfaceAssumption& surface,
                double* separation) {
  SearchHit hit;
  hit.description = device.description;
  hit.baseline_mm = baseline_mm;
  hit.coverage = 1.0;
  *separation = 1e9;
  double squares = 0.0;
  for (int k = 0; k < static_cast<int>(device.lasers.size()); ++k) {
    const VolumeFigures v = JudgeVolume(device, k, surface, 7, 3, 3);
    hit.coverage = std::min(hit.coverage, v.used);
    hit.spacing_mm = v.spacing_low_mm;
    hit.points_per_cm2 += v.points_per_cm2;
    squares += v.points_per_cm2 * std::pow(v.pooled_sigma_mm, 2);
    *separation = std::min(*separation, v.narrowest);
  }
  if (hit.points_per_cm2 > 0.0) hit.pooled_sigma_mm = std::sqrt(squares / hit.points_per_cm2);
  if (hit.pooled_sigma_mm > 0.0) hit.merit = hit.points_per_cm2 / hit.pooled_sigma_mm;
  const HeightAmbiguity ambiguity =
      FindAmbiguity(device, {.agreement_mm = 1.0, .height_step_mm = 4.0, .columns = 5, .rows = 3});
  hit.unambiguous_mm = *std::min_element(ambiguity.single_mm.begin(), ambiguity.single_mm.end());
  const SlitGrating grating = GratingOf(device.description.grating);
  hit.slit_um = SlitForBrightestOrder(grating, device.description.grating.orders);
  hit.central_efficiency = OrderEfficiency(grating, hit.slit_um, 0);
  if (device.lasers.size() > 1) {
    hit.pitch_mm = std::abs(device.lasers[1].fan.origin.x() - device.lasers[0].fan.origin.x());
  }
  return hit;
}

std::string NameOf(const DeviceDescription& d) {
  return std::to_string(d.lasers.size()) + " lasers, " + Figure(d.grating.lines_per_mm, 0) +
         " lines/mm, baseline " + Figure(std::abs(d.camera.position_mm.x() - MiddleOfLasers(d)), 0) + " mm";
}

// The best baseline of one grating, or why there is none.
std::optional<SearchHit> BestOfGrating(const DeviceDescription& d, const Eigen::Vector2d& hand_mm,
                                       const SurfaceAssumption& surface, const DesignSearch& search,
                                       std::string* why) {
  std::optional<SearchHit> best;
  double nearest = -1.0;
  *why = "leaves no camera height from " + Figure(search.camera_heights_mm[0], 0) + " to " +
         Figure(search.camera_heights_mm[1], 0) +
         " mm that shows the hand area and keeps the camera out of the light";
  for (double b = search.baselines_mm[0]; b <= search.baselines_mm[1] + 1e-9; b += kBaselineStepMm) {
    const auto device = PlaceCamera(d, b, hand_mm, search);
    if (!device || StandsInTheLight(*device)) continue;
    double separation = 0.0;
    const SearchHit hit = Judge(*device, b, surface, &separation);
    const bool fine = hit.unambiguous_mm >= search.least_unambiguous_mm &&
                      hit.coverage >= search.least_coverage && separation >= search.least_separation &&
                      hit.merit > 0.0;
    if (!fine) {
      const double near =
          std::min({hit.unambiguous_mm / search.least_unambiguous_mm, hit.coverage / search.least_coverage,
                    separation / search.least_separation});
      if (near > nearest && !best) {
        nearest = near;
        *why = "at best (baseline " + Figure(b, 0) + " mm) keeps heights " + Figure(hit.unambiguous_mm, 1) +
               " mm apart, lights " + Figure(100.0 * hit.coverage, 0) + " % and sets stripes " +
               Figure(separation, 1) + " widths apart";
      }
      continue;
    }
    if (!best || hit.merit > best->merit) best = hit;
  }
  if (best) best->description.name = NameOf(best->description);
  return best;
}

Status CheckSearch(const DesignSearch& s) {
  const auto pair = [](const std::vector<double>& v, double least, double most) {
    return v.size() == 2 && v[0] >= least && v[1] <= most && v[0] <= v[1];
  };
  for (const double lines : s.gratings) {
    if (!(lines >= 1.0 && lines <= 5000.0)) return UsageError("--gratings takes lines/mm from 1 to 5000");
  }
  if (!s.grating_range.empty() && !pair(s.grating_range, 1.0, 5000.0))
    return UsageError("--grating-range takes the lowest and the highest lines/mm, from 1 to 5000");
  if (s.gratings.empty() && s.grating_range.empty())
    return UsageError("--gratings names no grating; name one, or give --grating-range");
  if (!pair(s.baselines_mm, 10.0, 1000.0))
    return UsageError("--baselines takes the shortest and the longest in mm, from 10 to 1000");
  if (!pair(s.camera_heights_mm, 100.0, 3000.0))
    return UsageError("--camera-heights takes the lowest and the highest in mm, from 100 to 3000");
  return {};
}

}  // namespace

double BestPitch(const DeviceDescription& d, double least_mm) {
  const std::size_t lasers = d.lasers.size();
  const double height = d.lasers.front().position_mm.z();
  const double spacing = height * d.grating.Step();
  const auto& [low, high] = d.working_heights_mm;
  double best = least_mm, least_gap = 1e9;
  for (double pitch = least_mm; lasers > 1 && pitch <= least_mm + std::max(30.0, spacing); pitch += 0.25) {
    double gaps = 0.0;
    constexpr int kHeights = 17;
    for (int i = 0; i < kHeights; ++i) {
      const double z = low + (high - low) * i / (kHeights - 1.0);
      std::vector<double> phase;
      for (std::size_t k = 0; k < lasers; ++k) {
        const double at = pitch * static_cast<double>(k) / ((height - z) * d.grating.Step());
        phase.push_back(at - std::floor(at));
      }
      std::sort(phase.begin(), phase.end());
      double gap = phase.front() + 1.0 - phase.back(), closest = gap;
      for (std::size_t k = 1; k < lasers; ++k) {
        gap = std::max(gap, phase[k] - phase[k - 1]);
        closest = std::min(closest, phase[k] - phase[k - 1]);
      }
      // Stripes on one another cost as much as a gap that is half a spacing wider.
      gaps += 4.0 * std::max(0.0, kCombsCoincide - closest);
      gaps += gap;
    }
    if (gaps < least_gap - 1e-9) {
      least_gap = gaps;
      best = pitch;
    }
  }
  return best;
}

Result<SearchResult> SearchDesigns(const DeviceDescription& base, const Eigen::Vector2d& hand_mm,
                                   const SurfaceAssumption& surface, const DesignSearch& search,
                                   const Context& context) {
  DORSUM_RETURN_IF_ERROR(CheckSearch(search));
  const std::vector<double> gratings = Gratings(search);
  SearchResult result;
  for (std::size_t i = 0; i < gratings.size(); ++i) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    context.Report("searching gratings", static_cast<double>(i) / static_cast<double>(gratings.size()));
    std::string why;
    const auto device = WithGrating(base, gratings[i], hand_mm, search, &why);
    const auto hit = device ? BestOfGrating(*device, hand_mm, surface, search, &why) : std::nullopt;
    if (hit) {
      result.hits.push_back(*hit);
    } else {
      result.refused.push_back(Figure(gratings[i], 0) + " lines/mm " + why);
    }
  }
  if (result.hits.empty()) {
    std::string all;
    for (const std::string& why : result.refused) all += (all.empty() ? "" : "; ") + why;
    return Error{ErrorCode::kAnswerIsNo, "no grating meets the constraints: " + all};
  }
  std::stable_sort(result.hits.begin(), result.hits.end(),
                   [](const SearchHit& a, const SearchHit& b) { return a.merit > b.merit; });
  if (result.hits.size() > static_cast<std::size_t>(std::max(1, search.best)))
    result.hits.resize(static_cast<std::size_t>(std::max(1, search.best)));
  return result;
}

}  // namespace dorsum
