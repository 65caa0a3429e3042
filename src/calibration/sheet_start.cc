// SPDX-License-Identifier: Apache-2.0
#include "calibration/sheet_start.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>

#include "base/median.h"

namespace dorsum {
namespace {

// Least squares of x = at + slope y.
StripeLine FitLine(const std::vector<Eigen::Vector2d>& places) {
  double n = 0.0, y = 0.0, yy = 0.0, x = 0.0, xy = 0.0;
  for (const auto& p : places) {
    n += 1.0;
    y += p.y();
    yy += p.y() * p.y();
    x += p.x();
    xy += p.x() * p.y();
  }
  const double det = n * yy - y * y;
  StripeLine line;
  line.rows = n;
  line.slope = det > 1e-9 * n * n ? (n * xy - x * y) / det : 0.0;
  line.at = (x - line.slope * y) / n;
  return line;
}

// Pieces of one stripe become one line.
std::vector<StripeLine> Merge(std::vector<StripeLine> lines) {
  constexpr double kSame = 1.0;  // mm
  std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  std::vector<StripeLine> merged;
  for (const StripeLine& line : lines) {
    if (merged.empty() || line.at - merged.back().at > kSame) {
      merged.push_back(line);
      continue;
    }
    StripeLine& last = merged.back();
    const double w = line.rows / (line.rows + last.rows);
    last.at += w * (line.at - last.at);
    last.slope += w * (line.slope - last.slope);
    last.strength += w * (line.strength - last.strength);
    last.rows += line.rows;
  }
  return merged;
}

struct Numbered {
  double x = 0.0, z = 0.0;
  int order = 0;
};

// Orders counted from lines[central], going outward with a spacing that may grow slowly; what falls between
// is left out.
std::vector<Numbered> Count(const std::vector<StripeLine>& lines, std::size_t central, double z) {
  std::vector<double> steps;
  const std::size_t from = central > 3 ? central - 3 : 0, to = std::min(lines.size() - 1, central + 3);
  for (std::size_t i = from; i < to; ++i) steps.push_back(lines[i + 1].at - lines[i].at);
  const double usual = Median(steps);
  std::vector<Numbered> out = {{lines[central].at, z, 0}};
  for (const int way : {-1, 1}) {
    double last = lines[central].at, step = usual;
    int order = 0;
    for (auto i = static_cast<std::ptrdiff_t>(central) + way;
         i >= 0 && i < static_cast<std::ptrdiff_t>(lines.size()); i += way) {
      const double distance = std::abs(lines[static_cast<std::size_t>(i)].at - last);
      const double count = std::round(distance / step);
      if (count < 1.0 || std::abs(distance / step - count) > 0.3) continue;
      order += way * static_cast<int>(count);
      step += 0.4 * (distance / count - step);
      last = lines[static_cast<std::size_t>(i)].at;
      out.push_back({last, z, order});
    }
  }
  return out;
}

// g_x, g_z, alpha, step
using Section = Eigen::Vector4d;

double PredictX(const Section& s, double order, double z) {
  const double a = std::clamp(s[2] + order * s[3], -0.95, 0.95);
  return s[0] + (s[1] - z) * a / std::sqrt(1.0 - a * a);
}

// Levenberg-Marquardt with Cauchy weights; returns the cost.
double Refine(const std::vector<Numbered>& lines, const SheetStartOptions& o, Section* s) {
  const auto cost_of = [&](const Section& p) {
    double cost = 0.5 * std::pow(p[2] / o.tilt_sd, 2);
    for (const Numbered& l : lines) {
      const double r = (l.x - PredictX(p, l.order, l.z)) / o.usual_miss_mm;
      cost += 0.5 * std::log1p(r * r);
    }
    return cost;
  };
  double lambda = 1e-3, cost = cost_of(*s);
  for (int iteration = 0; iteration < 60; ++iteration) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    normal(2, 2) += 1.0 / (o.tilt_sd * o.tilt_sd);
    right[2] -= (*s)[2] / (o.tilt_sd * o.tilt_sd);
    for (const Numbered& l : lines) {
      const double r = (l.x - PredictX(*s, l.order, l.z)) / o.usual_miss_mm;
      Eigen::Vector4d row;
      for (int k = 0; k < 4; ++k) {
        constexpr double kStep = 1e-6;
        Section high = *s, low = *s;
        high[k] += kStep;
        low[k] -= kStep;
        row[k] =
            (PredictX(high, l.order, l.z) - PredictX(low, l.order, l.z)) / (2.0 * kStep) / o.usual_miss_mm;
      }
      const double w = 1.0 / (1.0 + r * r);
      normal += w * row * row.transpose();
      right += w * r * row;
    }
    Eigen::Matrix4d damped = normal;
    damped.diagonal() *= 1.0 + lambda;
    const Section next = *s + damped.ldlt().solve(right);
    const double next_cost = cost_of(next);
    if (std::isfinite(next_cost) && next_cost < cost) {
      const bool done = cost - next_cost < 1e-9 * cost;
      *s = next;
      cost = next_cost;
      lambda = std::max(1e-9, 0.2 * lambda);
      if (done) break;
    } else {
      lambda *= 10.0;
      if (lambda > 1e9) break;
    }
  }
  return cost;
}

// Orders anew from the model, so that what Count() left out or miscounted falls into place.
std::vector<Numbered> Recount(const std::vector<StripeLine>& lines, double z, const Section& s) {
  std::vector<Numbered> out;
  for (const StripeLine& line : lines) {
    const double t = (line.at - s[0]) / (s[1] - z);
    const double order = (t / std::sqrt(1.0 + t * t) - s[2]) / s[3];
    if (std::abs(order - std::round(order)) < 0.3)
      out.push_back({line.at, z, static_cast<int>(std::lround(order))});
  }
  return out;
}

std::size_t Strongest(const std::vector<StripeLine>& lines) {
  return static_cast<std::size_t>(
      std::max_element(lines.begin(), lines.end(),
                       [](const auto& a, const auto& b) { return a.strength < b.strength; }) -
      lines.begin());
}

std::size_t Nearest(const std::vector<StripeLine>& lines, double x) {
  return static_cast<std::size_t>(std::min_element(lines.begin(), lines.end(),
                                                   [x](const auto& a, const auto& b) {
                                                     return std::abs(a.at - x) < std::abs(b.at - x);
                                                   }) -
                                  lines.begin());
}

// Do the stripes of the nearer picture lie where the backplane's do? Then nothing stood there. A real shift
// is a whole order at a few places only, since it changes across the picture.
bool LieTogether(const std::vector<StripeLine>& lines, const std::vector<StripeLine>& backplane) {
  constexpr double kSame = 0.7, kShare = 0.8;  // mm; of the lines
  const auto same = std::count_if(lines.begin(), lines.end(), [&](const StripeLine& line) {
    return std::abs(backplane[Nearest(backplane, line.at)].at - line.at) < kSame;
  });
  return static_cast<double>(same) > kShare * static_cast<double>(lines.size());
}

DiffractedFan FanOf(const Section& s, double slope) {
  DiffractedFan fan;
  const double turn = std::atan(slope);  // stripes run along (slope, 1)
  fan.a = {std::cos(turn), -std::sin(turn), 0.0};
  fan.b = {-std::sin(turn), -std::cos(turn), 0.0};
  fan.n = -Eigen::Vector3d::UnitZ();
  fan.origin = {s[0], 0.0, s[1]};
  fan.fan_distance_mm = 15.0;
  fan.tilt = std::asin(s[2]);
  fan.step = s[3];
  fan.form = FanForm::kGeneral;
  fan.bow = 0.5 * s[2];
  return fan;
}

}  // namespace

std::vector<StripeLine> LinesOnPlane(const Camera& camera, const LaserStripes& stripes, double z_mm,
                                     const SheetStartOptions& options) {
  std::vector<StripeLine> lines;
  for (const StripeSegment& segment : stripes.segments) {
    std::vector<Eigen::Vector2d> places;
    std::vector<double> peaks;
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
      const Ray ray = CastRay(camera, {p.u, p.v});
      const auto t = Intersect(ray, Plane{Eigen::Vector3d::UnitZ(), z_mm});
      if (!t) continue;
      const Eigen::Vector3d at = ray.At(*t);
      if (std::abs(at.y()) > options.band_mm) continue;
      places.emplace_back(at.x(), at.y());
      peaks.push_back(p.peak);
    }
    if (places.size() < 12) continue;
    StripeLine line = FitLine(places);
    line.strength = Median(peaks);
    lines.push_back(line);
  }
  lines = Merge(std::move(lines));
  std::vector<double> strengths;
  strengths.reserve(lines.size());
  for (const StripeLine& line : lines) strengths.push_back(line.strength);
  const double weak = options.weak_share * Median(strengths);
  std::erase_if(lines, [weak](const StripeLine& line) { return line.strength < weak; });
  return lines;
}

Result<SheetStart> EstimateSheets(const Camera& camera, const LaserStripes& far, const LaserStripes& near,
                                  double near_z_mm, std::optional<double> central_x_mm,
                                  const SheetStartOptions& options) {
  const std::vector<StripeLine> on_far = LinesOnPlane(camera, far, 0.0, options),
                                on_near = LinesOnPlane(camera, near, near_z_mm, options);
  const std::string who = "laser " + std::to_string(far.laser);
  for (const auto* lines : {&on_far, &on_near}) {
    if (static_cast<int>(lines->size()) >= options.min_lines) continue;
    return BadInput(
        "only " + std::to_string(lines->size()) + " stripes of " + who + " are seen on " +
        (lines == &on_far ? "the backplane; capture stripesBg" : "the calibration object; capture laser") +
        std::to_string(far.laser) + (lines == &on_far ? "" : "CalCloser") + " again with a longer exposure");
  }
  const std::size_t central = central_x_mm ? Nearest(on_far, *central_x_mm) : Strongest(on_far);
  const std::vector<Numbered> far_numbered = Count(on_far, central, 0.0);
  const auto near_numbered = Count(on_near, Strongest(on_near), near_z_mm);
  const auto spacing = [](const std::vector<Numbered>& n) {
    std::vector<double> steps;
    for (const Numbered& l : n) {
      if (l.order != 0) steps.push_back((l.x - n[0].x) / l.order);
    }
    return Median(steps);
  };
  const double ratio = spacing(near_numbered) / std::max(1e-9, spacing(far_numbered));
  const Error swapped = BadInput(
      "the stripes of " + who +
      " on the backplane and on the calibration object do not belong to one grating; are the Closer and "
      "Further images swapped?");
  if (!(ratio < 0.999) || LieTogether(LinesOnPlane(camera, near, 0.0, options), on_far)) return swapped;
  SheetStart best;
  Section best_section = Section::Zero();
  double least = 1e300;
  for (int shift = -3; shift <= 3; ++shift) {
    Section s;
    s[1] = std::clamp(near_z_mm / std::max(0.01, 1.0 - ratio), 2.0 * near_z_mm, 60.0 * near_z_mm);
    s[0] = on_far[central].at;
    s[2] = 0.0;
    s[3] = spacing(far_numbered) / s[1];
    std::vector<Numbered> all = far_numbered;
    for (Numbered n : near_numbered) {
      n.order += shift;
      all.push_back(n);
    }
    double cost = Refine(all, options, &s);
    for (int pass = 0; pass < 2 && std::isfinite(cost) && s[3] > 1e-4 && s[1] > 1.2 * near_z_mm; ++pass) {
      all = Recount(on_far, 0.0, s);
      const auto again = Recount(on_near, near_z_mm, s);
      all.insert(all.end(), again.begin(), again.end());
      // Lines that fit no order cost as much as far outliers do.
      const auto left = static_cast<double>(on_far.size() + on_near.size() - all.size());
      cost = Refine(all, options, &s) + 3.0 * left;
    }
    if (!(cost < least) || s[3] <= 1e-4 || s[1] <= 1.2 * near_z_mm) continue;
    least = cost;
    best_section = s;
    best.central_shift = shift;
    double square = 0.0;
    for (const Numbered& l : all) square += std::pow(l.x - PredictX(s, l.order, l.z), 2);
    best.rms_mm = std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, all.size())));
  }
  if (least >= 1e300) return swapped;
  std::vector<double> slopes;
  slopes.reserve(on_far.size());
  for (const StripeLine& line : on_far) slopes.push_back(line.slope);
  best.fan = FanOf(best_section, Median(slopes));
  best.far_lines = static_cast<int>(on_far.size());
  best.near_lines = static_cast<int>(on_near.size());
  return best;
}

}  // namespace dorsum
