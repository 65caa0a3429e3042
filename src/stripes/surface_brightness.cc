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

#include <Eigen/Cholesky>
#include <opencv2/imgproc.hpp>

#include "base/median.h"

namespace dorsum {
namespace {

constexpr int kCellPx = 4;  // stripes are compared with the picture in cells of this side
constexpr float kClippedPeak = 200.0F;
constexpr float kWholeInside = 10.0F;  // px from the outline from where a stripe shows its own strength
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

cv::Mat1f DistanceInside(const cv::Mat& mask) {
  cv::Mat framed;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(framed, framed, cv::DIST_L2, cv::DIST_MASK_5);
  return framed(cv::Rect(1, 1, mask.cols, mask.rows));
}

}  // namespace

SurfaceBrightness::SurfaceBrightness(const cv::Mat& green, const cv::Mat& mask, const IndexedStripes& stripes,
                                     const SurfaceBrightnessOptions& options)
    : options_(options), part_(cv::boundingRect(mask)) {
  if (part_.empty()) return;
  inside_px_ = DistanceInside(mask(part_));
  cv::Mat1f weight;
  cv::Mat(inside_px_ > static_cast<double>(options.margin_px)).convertTo(weight, CV_32F, 1.0 / 255.0);
  level_ = SmoothLogarithm(green(part_), weight, options.smooth_px);
  Compare(stripes);
}

bool SurfaceBrightness::IsInside(int u, int v) const {
  return part_.contains({u, v}) &&
         inside_px_(v - part_.y, u - part_.x) > static_cast<float>(options_.margin_px);
}

double SurfaceBrightness::LevelAt(double u, int v) const {
  const int y = v - part_.y;
  const double x = u - part_.x;
  const int x0 = std::clamp(static_cast<int>(std::floor(x)), 0, level_.cols - 1);
  const int x1 = std::min(x0 + 1, level_.cols - 1);
  const double share = std::clamp(x - x0, 0.0, 1.0);
  return (1.0 - share) * static_cast<double>(level_(y, x0)) + share * static_cast<double>(level_(y, x1));
}

void SurfaceBrightness::Compare(const IndexedStripes& stripes) {
  struct Sample {
    int cell_x, cell_y;
    float ratio, level;
    bool whole;
  };
  const cv::Size size(part_.width / kCellPx + 1, part_.height / kCellPx + 1);
  cell_ratio_ = cv::Mat1f(size, 0.0F);
  cell_level_ = cv::Mat1f(size, 0.0F);
  cell_weight_ = cv::Mat1f(size, 0.0F);
  for (const LaserStripes& one : stripes.lasers) {
    std::map<int, std::vector<Sample>> by_order;
    for (const StripeSegment& s : one.segments) {
      if (!s.order) continue;
      std::vector<Sample>& samples = by_order[*s.order];
      for (std::int32_t i = s.first; i < s.first + s.count; ++i) {
        const StripePoint& p = one.points[static_cast<std::size_t>(i)];
        const cv::Point at(cvRound(p.u), cvRound(p.v));
        if (!part_.contains(at) || p.peak >= kClippedPeak) continue;
        const cv::Point here = at - part_.tl();
        if (inside_px_(here) <= static_cast<float>(options_.margin_px)) continue;
        const auto level = static_cast<float>(LevelAt(static_cast<double>(p.u), at.y));
        samples.push_back({here.x / kCellPx, here.y / kCellPx, std::log(std::max(1.0F, p.peak)) - level,
                           level, inside_px_(here) > kWholeInside});
      }
    }
    for (const auto& [order, samples] : by_order) {
      std::vector<float> whole;
      for (const Sample& s : samples) {
        if (s.whole) whole.push_back(s.ratio);
      }
      if (whole.size() < kLeastRows) continue;
      const float strength = Median(whole);
      strength_[{one.laser, order}] = static_cast<double>(strength);
      for (const Sample& s : samples) {
        cell_ratio_(s.cell_y, s.cell_x) += s.ratio - strength;
        cell_level_(s.cell_y, s.cell_x) += s.level;
        cell_weight_(s.cell_y, s.cell_x) += 1.0F;
      }
    }
  }
  const cv::Mat1f least_one = cv::max(cell_weight_, 1.0F);
  cell_ratio_ /= least_one;
  cell_level_ /= least_one;
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

// Local regression, drawn towards 0: speckle makes a row's peak err by a tenth or more, alike over some rows.
SurfaceBrightness::Slope SurfaceBrightness::FitRatio(double u, double v, double level) const {
  constexpr double kNoise = 0.04;                           // variance of a ratio, rows being alike
  constexpr double kSlope = 0.006 * kCellPx, kShare = 0.5;  // usual sizes of the two slopes
  const double x = (u - part_.x + 0.5) / kCellPx - 0.5, y = (v - part_.y + 0.5) / kCellPx - 0.5;
  const double sd = options_.window_px / kCellPx, reach = 2.5 * sd;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (int r = std::max(0, static_cast<int>(std::ceil(y - reach)));
       r <= std::min(cell_weight_.rows - 1, static_cast<int>(y + reach)); ++r) {
    for (int c = std::max(0, static_cast<int>(std::ceil(x - reach)));
         c <= std::min(cell_weight_.cols - 1, static_cast<int>(x + reach)); ++c) {
      if (cell_weight_(r, c) <= 0.0F) continue;
      const double dx = c - x, dy = r - y;
      const Eigen::Vector4d row(1.0, dx, dy, static_cast<double>(cell_level_(r, c)) - level);
      const double w =
          static_cast<double>(cell_weight_(r, c)) * std::exp(-0.5 * (dx * dx + dy * dy) / (sd * sd));
      matrix += w * row * row.transpose();
      right += w * static_cast<double>(cell_ratio_(r, c)) * row;
    }
  }
  matrix.diagonal() += kNoise * Eigen::Vector4d(1.0, 1.0 / (kSlope * kSlope), 1.0 / (kSlope * kSlope),
                                                1.0 / (kShare * kShare));
  const Eigen::Vector4d solved = matrix.ldlt().solve(right);
  return {solved[1] / kCellPx, std::max(-1.0, solved[3])};
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
    std::fill(gain + first, gain + last + 1, 1.0F);
    return std::nullopt;
  }
  const auto level = static_cast<double>(level_(v - part_.y, middle - part_.x));
  const Slope slope = FitRatio(u, v, level);
  for (int x = first; x <= last; ++x) {
    const double change =
        inside(x) ? (1.0 + slope.of_level) * (static_cast<double>(level_(v - part_.y, x - part_.x)) - level) +
                        slope.along_u * (x - middle)
                  : 0.0;
    gain[x] = inside(x) ? static_cast<float>(std::exp(std::clamp(change, -3.0, 3.0))) : 0.0F;
  }
  return level;
}

}  // namespace dorsum
