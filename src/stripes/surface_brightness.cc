// SPDX-License-Identifier: Apache-2.0
#include "stripes/surface_brightness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/median.h"

namespace dorsum {
namespace {

constexpr float kClippedPeak = 200.0F;
constexpr int kWholeInside = 10;  // px from the outline from where a stripe shows its own strength
constexpr std::size_t kLeastRows = 20;

// The logarithm where the object is whole, smoothed without what lies beyond.
cv::Mat1f SmoothLogarithm(const cv::Mat& green, const cv::Mat1f& weight, double sd) {
  std::array<float, 256> logarithm{};
  for (std::size_t g = 0; g < 256; ++g) {
    logarithm[g] = static_cast<float>(std::log(std::max(2.0, static_cast<double>(g))));
  }
  cv::Mat1f level, share;
  cv::LUT(green, cv::Mat(1, 256, CV_32F, logarithm.data()), level);
  cv::GaussianBlur(level.mul(weight), level, {}, sd, sd, cv::BORDER_CONSTANT);
  cv::GaussianBlur(weight, share, {}, sd, sd, cv::BORDER_CONSTANT);
  return level / cv::max(share, 1e-6F);
}

// What is left of the mask without everything within `margin_px` of its outline; the border of the picture is
// one.
cv::Mat1b Shrunk(const cv::Mat& mask, int margin_px, int shape) {
  const cv::Size side(2 * margin_px + 1, 2 * margin_px + 1);
  cv::Mat1b out;
  cv::erode(mask != 0, out, cv::getStructuringElement(shape, side), {-1, -1}, 1, cv::BORDER_CONSTANT,
            cv::Scalar(0));
  return out;
}

}  // namespace

SurfaceBrightness::SurfaceBrightness(const cv::Mat& green, const cv::Mat& mask, const IndexedStripes& stripes,
                                     const SurfaceBrightnessOptions& options, const Context& context)
    : options_(options), part_(cv::boundingRect(mask)) {
  if (part_.empty()) return;
  inside_ = Shrunk(mask(part_), options.margin_px, cv::MORPH_ELLIPSE);
  cv::Mat1f weight;
  inside_.convertTo(weight, CV_32F, 1.0 / 255.0);
  level_ = SmoothLogarithm(green(part_), weight, options.smooth_px);
  Compare(stripes, context);
}

bool SurfaceBrightness::IsInside(int u, int v) const {
  return part_.contains({u, v}) && inside_(v - part_.y, u - part_.x) != 0;
}

double SurfaceBrightness::LevelAt(double u, int v) const {
  const int y = v - part_.y;
  const double x = u - part_.x;
  const int x0 = std::clamp(static_cast<int>(std::floor(x)), 0, level_.cols - 1);
  const int x1 = std::min(x0 + 1, level_.cols - 1);
  const double share = std::clamp(x - x0, 0.0, 1.0);
  return (1.0 - share) * static_cast<double>(level_(y, x0)) + share * static_cast<double>(level_(y, x1));
}

void SurfaceBrightness::Compare(const IndexedStripes& stripes, const Context& context) {
  std::vector<RatioSample> all;
  const cv::Mat1b whole_part =
      Shrunk(inside_, std::max(0, kWholeInside - options_.margin_px), cv::MORPH_RECT);
  for (const LaserStripes& one : stripes.lasers) {
    std::map<int, std::vector<RatioSample>> by_order;
    for (const StripeSegment& s : one.segments) {
      if (!s.order) continue;
      std::vector<RatioSample>& samples = by_order[*s.order];
      for (std::int32_t i = s.first; i < s.first + s.count; ++i) {
        const StripePoint& p = one.points[static_cast<std::size_t>(i)];
        const cv::Point at(cvRound(p.u), cvRound(p.v));
        if (p.peak >= kClippedPeak || !IsInside(at.x, at.y)) continue;
        const auto level = static_cast<float>(LevelAt(static_cast<double>(p.u), at.y));
        const cv::Point here = at - part_.tl();
        samples.push_back({static_cast<float>(here.x), static_cast<float>(here.y),
                           std::log(std::max(1.0F, p.peak)) - level, level});
      }
    }
    for (auto& [order, samples] : by_order) {
      std::vector<float> whole;
      for (const RatioSample& s : samples) {
        if (whole_part(static_cast<int>(s.v), static_cast<int>(s.u)) != 0) whole.push_back(s.ratio);
      }
      if (whole.size() < kLeastRows) continue;
      const float strength = Median(std::move(whole));
      strength_[{one.laser, order}] = static_cast<double>(strength);
      for (RatioSample& s : samples) {
        s.ratio -= strength;
        all.push_back(s);
      }
    }
  }
  ratio_ = BrightnessRatio(part_.size(), all, options_.window_px, context);
}

// Efficiencies fall from the central order outwards (§2.5), so a stripe is at least as strong as the weaker
// of its neighbours, and little weaker than a single one. A stripe that runs along an edge does not show that
// itself.
std::optional<double> SurfaceBrightness::StrengthOf(int laser, int order) const {
  constexpr double kStep = 0.2;  // most that one order's logarithm falls behind the next
  const auto own = strength_.find({laser, order});
  const auto after = strength_.upper_bound({laser, order});
  const auto at = strength_.lower_bound({laser, order});
  const bool has_after = after != strength_.end() && after->first.first == laser;
  const bool has_before = at != strength_.begin() && std::prev(at)->first.first == laser;
  std::optional<double> least;
  if (has_after && has_before) {
    least = std::min(after->second, std::prev(at)->second);
  } else if (has_after || has_before) {
    least = (has_after ? after : std::prev(at))->second - kStep;
  }
  if (own == strength_.end()) return least;
  return std::max(own->second, least.value_or(own->second));
}

std::optional<double> SurfaceBrightness::RatioOf(int laser, int order, const StripePoint& point,
                                                 double width_px) const {
  const std::optional<double> strength = StrengthOf(laser, order);
  const int v = cvRound(point.v);
  if (!strength || !part_.contains({cvRound(point.u), v}) || point.peak >= kClippedPeak) return std::nullopt;
  // Light at a step comes from its bright side.
  const double reach = 1.2 * width_px;
  double level = 0.0;
  for (double u = point.u - reach; u <= point.u + reach; u += 0.5) {
    if (IsInside(cvRound(u), v)) level = std::max(level, LevelAt(u, v));
  }
  if (level == 0.0) level = LevelAt(static_cast<double>(point.u), v);
  return std::log(std::max(1.0, static_cast<double>(point.peak))) - level - *strength;
}

std::optional<double> SurfaceBrightness::Along(double u, int v, int first, int last, float* gain) const {
  const auto inside = [&](int x) { return IsInside(x, v); };
  // The column that the others are measured against: the nearest to u that is known.
  int middle = std::clamp(cvRound(u), first, last);
  for (int away = 0; away <= last - first && !inside(middle); ++away) {
    const int next = cvRound(u) + (away % 2 == 0 ? 1 : -1) * (away / 2 + 1);
    if (next >= first && next <= last && inside(next)) middle = next;
  }
  if (!inside(middle)) {
    std::fill(gain, gain + (last + 1 - first), 1.0F);
    return std::nullopt;
  }
  const auto level = static_cast<double>(level_(v - part_.y, middle - part_.x));
  const RatioSlope slope = ratio_.At(u - part_.x, v - part_.y, level);
  for (int x = first; x <= last; ++x) {
    const double change =
        inside(x) ? (1.0 + slope.of_level) * (static_cast<double>(level_(v - part_.y, x - part_.x)) - level) +
                        slope.along_u * (x - middle)
                  : 0.0;
    gain[x - first] = inside(x) ? static_cast<float>(std::exp(std::clamp(change, -3.0, 3.0))) : 0.0F;
  }
  return level;
}

}  // namespace dorsum
