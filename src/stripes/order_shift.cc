// SPDX-License-Identifier: Apache-2.0
#include "stripes/order_shift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "base/parallel.h"

namespace dorsum {
namespace {

// Logarithms by order.
using Levels = std::map<int, double>;

Levels LevelsOnObject(const LaserStripes& one, const cv::Mat& smooth, int min_rows) {
  std::map<int, std::vector<double>> samples;
  const cv::Rect picture({}, smooth.size());
  for (const StripeSegment& s : one.segments) {
    if (!s.order) continue;
    for (std::int32_t i = s.first; i < s.first + s.count; ++i) {
      const StripePoint& p = one.points[static_cast<std::size_t>(i)];
      const cv::Point at(cvRound(p.u), cvRound(p.v));
      if (!picture.contains(at)) continue;
      const double led = smooth.at<std::uint8_t>(at);
      samples[*s.order].push_back(std::log(std::max(1.0F, p.peak)) - std::log(std::max(2.0, led)));
    }
  }
  Levels levels;
  for (auto& [order, values] : samples) {
    if (static_cast<int>(values.size()) >= min_rows) levels[order] = Median(std::move(values));
  }
  return levels;
}

// The picture, smoothed as far as stripes reach.
cv::Mat SmoothAround(const IndexedStripes& stripes, const cv::Mat& green) {
  float left = 1e9F, right = -1e9F, top = 1e9F, bottom = -1e9F;
  for (const LaserStripes& one : stripes.lasers) {
    for (const StripeSegment& s : one.segments) {
      left = std::min(left, s.min_u);
      right = std::max(right, s.max_u);
      top = std::min(top, s.min_v);
      bottom = std::max(bottom, s.max_v);
    }
  }
  cv::Mat smooth(green.size(), CV_8UC1);
  const cv::Rect part =
      cv::Rect(cv::Point(cvRound(left), cvRound(top)), cv::Point(cvRound(right) + 1, cvRound(bottom) + 1)) &
      cv::Rect({}, green.size());
  if (left <= right && !part.empty()) cv::blur(green(part), smooth(part), {5, 5});
  return smooth;
}

Levels LevelsOnBackplane(const LaserGeometry& laser) {
  Levels levels;
  for (const ReferenceStripe& r : laser.reference) {
    levels[r.order] = std::log(std::max(1.0, r.PeakAt(r.middle_v)));
  }
  return levels;
}

// Mean deviation from a line over the orders, of those that both know when `shift` is added; infinite for too
// few.
double Deviation(const Levels& object, const Levels& backplane, int shift, int min_orders) {
  std::vector<std::pair<double, double>> points;
  for (const auto& [order, level] : object) {
    const auto reference = backplane.find(order + shift);
    if (reference != backplane.end()) points.emplace_back(order, level - reference->second);
  }
  if (static_cast<int>(points.size()) < min_orders) return std::numeric_limits<double>::infinity();
  // The median of the slopes between all pairs, and of what they leave (Theil 1950, Sen 1968).
  std::vector<double> slopes, rest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      slopes.push_back((points[k].second - points[i].second) / (points[k].first - points[i].first));
    }
  }
  const double slope = Median(std::move(slopes));
  for (const auto& [order, value] : points) rest.push_back(value - slope * order);
  const double middle = Median(rest);
  double sum = 0.0;
  for (const double r : rest) sum += std::abs(r - middle);
  return sum / static_cast<double>(rest.size());
}

}  // namespace

OrderShift FindOrderShift(const IndexedStripes& stripes, const cv::Mat& green, const DeviceGeometry& device,
                          const OrderShiftOptions& options, const Context& context) {
  const cv::Mat smooth = SmoothAround(stripes, green);
  std::vector<Levels> on_object(stripes.lasers.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(on_object.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    on_object[k] = LevelsOnObject(stripes.lasers[k], smooth, options.min_rows);
  });
  std::map<int, double> sums;  // of the lasers' deviations, by shift
  OrderShift out;
  for (std::size_t k = 0; k < on_object.size(); ++k) {
    const LaserGeometry* laser = device.FindLaser(stripes.lasers[k].laser);
    if (laser == nullptr) continue;
    const Levels& object = on_object[k];
    const Levels backplane = LevelsOnBackplane(*laser);
    if (!std::isfinite(Deviation(object, backplane, 0, options.min_orders))) continue;
    ++out.lasers;
    for (int s = -options.max_shift; s <= options.max_shift; ++s) {
      sums[s] += Deviation(object, backplane, s, options.min_orders);
    }
  }
  if (out.lasers == 0) return out;
  const auto best = std::min_element(sums.begin(), sums.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  out.left = sums[0] / out.lasers;
  if (best->second < options.better * sums[0]) out.shift = best->first;
  out.left_shifted = sums[out.shift] / out.lasers;
  return out;
}

}  // namespace dorsum
