// SPDX-License-Identifier: Apache-2.0
#include "calibration/background_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <Eigen/Dense>

#include "captures/green_channel.h"

namespace dorsum {
namespace {

Eigen::Vector2d OnBackplane(const Camera& camera, const StripePoint& p) {
  const Ray ray = CastRay(camera, {p.u, p.v});
  const auto t = Intersect(ray, Plane{});
  return t ? Eigen::Vector2d(ray.At(*t).head<2>()) : Eigen::Vector2d(1e9, 1e9);
}

// Position in the sequence of known lines, as a real number; the spacing goes on beyond the ends.
double SequencePosition(const std::vector<double>& xs, double x) {
  std::size_t i = 1;
  while (i + 1 < xs.size() && x > xs[i]) ++i;
  return static_cast<double>(i - 1) + (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
}

// Level of the stripe that passes nearest to the central position at y = 0.
int CentralLevel(const LaserStripes& stripes, const StripeTree& tree,
                 const std::vector<Eigen::Vector2d>& places, double central_x_mm) {
  std::map<int, std::pair<double, int>> distance;  // by level: sum, count
  for (std::size_t i = 0; i < stripes.points.size(); ++i) {
    if (std::abs(places[i].y()) > 20.0) continue;
    auto& [sum, count] = distance[tree.nodes[static_cast<std::size_t>(stripes.points[i].segment)].level];
    sum += std::abs(places[i].x() - central_x_mm);
    ++count;
  }
  int level = 0;
  double least = 1e18;
  for (const auto& [candidate, entry] : distance) {
    const double mean = entry.first / entry.second;
    if (mean >= least) continue;
    least = mean;
    level = candidate;
  }
  return level;
}

BackgroundLine FitLine(int order, const std::vector<Eigen::Vector2d>& places) {
  double s1 = 0.0, s2 = 0.0, t0 = 0.0, t1 = 0.0;
  const auto n = static_cast<double>(places.size());
  for (const auto& p : places) {
    s1 += p.y();
    s2 += p.y() * p.y();
    t0 += p.x();
    t1 += p.x() * p.y();
  }
  const double det = n * s2 - s1 * s1;
  BackgroundLine line;
  line.order = order;
  line.points = static_cast<int>(places.size());
  line.slope = (n * t1 - s1 * t0) / det;
  line.at = (t0 - line.slope * s1) / n;
  double square = 0.0;
  for (const auto& p : places) square += std::pow(p.x() - line.at - line.slope * p.y(), 2);
  line.rms_mm = std::sqrt(square / n);
  return line;
}

template <int N>
std::array<double, N> FitPolynomial(const std::vector<double>& t, const std::vector<double>& value) {
  Eigen::Matrix<double, N, N> normal = Eigen::Matrix<double, N, N>::Zero();
  Eigen::Matrix<double, N, 1> right = Eigen::Matrix<double, N, 1>::Zero();
  for (std::size_t i = 0; i < t.size(); ++i) {
    Eigen::Matrix<double, N, 1> row;
    row[0] = 1.0;
    for (int k = 1; k < N; ++k) row[k] = row[k - 1] * t[i];
    normal += row * row.transpose();
    right += row * value[i];
  }
  const Eigen::Matrix<double, N, 1> c = normal.ldlt().solve(right);
  std::array<double, N> out{};
  for (int k = 0; k < N; ++k) out[static_cast<std::size_t>(k)] = c[k];
  return out;
}

ReferenceStripe FitReference(int order, const std::vector<StripePoint>& points) {
  ReferenceStripe r;
  r.order = order;
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [](const auto& a, const auto& b) { return a.v < b.v; });
  r.middle_v = 0.5 * (static_cast<double>(low->v) + high->v);
  r.half_v = std::max(1.0, 0.5 * (static_cast<double>(high->v) - low->v));
  std::vector<double> t, u, peak;
  for (const StripePoint& p : points) {
    t.push_back((p.v - r.middle_v) / r.half_v);
    u.push_back(p.u);
    peak.push_back(p.peak);
  }
  r.u = FitPolynomial<4>(t, u);
  r.peak = FitPolynomial<3>(t, peak);
  return r;
}

}  // namespace

Result<BackgroundModel> ModelBackground(const cv::Mat& image, int laser, const Camera& camera,
                                        double central_x_mm, const std::vector<double>& line_x_mm,
                                        const BackgroundModelOptions& options, const Context& context) {
  const std::string key = "background/" + std::to_string(laser);
  const cv::Mat mask = ExtractStripeMask(image, {}, options.mask, key, context);
  BackgroundModel model;
  model.stripes = SmoothSegments(ExtractClassicSegments(mask, GreenChannel(image), laser, options.segments),
                                 options.segments.min_rows, options.smoothing);
  LaserStripes& stripes = model.stripes;
  std::vector<Eigen::Vector2d> places(stripes.points.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = OnBackplane(camera, stripes.points[i]);

  StripeTree tree = BuildStripeTree(&stripes, options.indexing.min_shared_rows);
  const BackplaneOrder backplane = [&](float u, float v) {
    return SequencePosition(line_x_mm, OnBackplane(camera, {.u = u, .v = v}).x());
  };
  CorrectGaps(stripes, backplane, options.indexing.gaps, &tree);
  const int central = CentralLevel(stripes, tree, places, central_x_mm);
  std::map<int, std::vector<Eigen::Vector2d>> by_order;
  std::map<int, std::vector<StripePoint>> points_by_order;
  for (std::size_t s = 0; s < stripes.segments.size(); ++s) {
    StripeSegment& segment = stripes.segments[s];
    segment.order = tree.nodes[s].level - central;
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      by_order[*segment.order].push_back(places[static_cast<std::size_t>(i)]);
      points_by_order[*segment.order].push_back(stripes.points[static_cast<std::size_t>(i)]);
    }
  }
  for (const auto& [order, points] : by_order) {
    if (static_cast<int>(points.size()) < options.min_points) continue;
    model.lines.push_back(FitLine(order, points));
    model.reference.push_back(FitReference(order, points_by_order[order]));
  }
  if (model.lines.size() < 3) {
    return BadInput("only " + std::to_string(model.lines.size()) + " whole stripes of laser " +
                    std::to_string(laser) + " are seen in stripesBg" + std::to_string(laser) +
                    "; capture it again with a longer exposure");
  }
  return model;
}

std::vector<PlaneSheet> PlanesThroughGrating(const Eigen::Vector3d& grating,
                                             const std::vector<BackgroundLine>& lines) {
  std::vector<PlaneSheet> planes;
  const auto add = [&](int order, double at, double slope) {
    const Eigen::Vector3d on_line(at, 0.0, 0.0), along(slope, 1.0, 0.0);
    Eigen::Vector3d normal = along.cross(grating - on_line).normalized();
    if (normal.x() < 0.0) normal = -normal;
    planes.push_back({order, Plane{normal, normal.dot(on_line)}});
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) {
      const BackgroundLine& a = lines[i - 1];
      const BackgroundLine& b = lines[i];
      for (int order = a.order + 1; order < b.order; ++order) {
        const double t = static_cast<double>(order - a.order) / (b.order - a.order);
        add(order, a.at + t * (b.at - a.at), a.slope + t * (b.slope - a.slope));
      }
    }
    add(lines[i].order, lines[i].at, lines[i].slope);
  }
  return planes;
}

}  // namespace dorsum
