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
#include "base/parallel.h"
#include "stripes/vector_exp.h"

namespace dorsum {
namespace {

constexpr float kClippedPeak = 200.0F;
constexpr int kWholeInside = 10;  // px from the outline from where a stripe shows its own strength
constexpr std::size_t kLeastRows = 20;

// The logarithm where the object is whole, smoothed without what lies beyond.
cv::Mat1f SmoothLogarithm(const cv::Mat& green, const cv::Mat1b& inside, double sd, const Context& context) {
  constexpr int kRowsTogether = 64;
  std::array<float, 256> logarithm{};
  for (std::size_t g = 0; g < 256; ++g) {
    logarithm[g] = static_cast<float>(std::log(std::max(2.0, static_cast<double>(g))));
  }
  cv::Mat1f weight(green.size()), weighted(green.size()), level(green.size());
  ParallelFor(context, 0, green.rows, [&](std::int64_t row) {
    const int v = static_cast<int>(row);
    const auto *grey = green.ptr<std::uint8_t>(v), *in = inside[v];
    float *w = weight[v], *wl = weighted[v];
    for (int u = 0; u < green.cols; ++u) {
      w[u] = in[u] != 0 ? 1.0F : 0.0F;
      wl[u] = w[u] * logarithm[grey[u]];
    }
  });
  // Rows of a larger picture are smoothed with those beside them.
  ParallelFor(context, 0, (green.rows + kRowsTogether - 1) / kRowsTogether, [&](std::int64_t block) {
    const int first = static_cast<int>(block) * kRowsTogether;
    const cv::Range rows(first, std::min(first + kRowsTogether, green.rows));
    cv::Mat1f sum, share;
    cv::GaussianBlur(weighted.rowRange(rows), sum, {}, sd, sd, cv::BORDER_CONSTANT);
    cv::GaussianBlur(weight.rowRange(rows), share, {}, sd, sd, cv::BORDER_CONSTANT);
    level.rowRange(rows) = sum / cv::max(share, 1e-6F);
  });
  return level;
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
  level_ = SmoothLogarithm(green(part_), inside_, options.smooth_px, context);
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

std::map<int, std::vector<RatioSample>> SurfaceBrightness::SamplesByOrder(const LaserStripes& one) const {
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
  return by_order;
}

void SurfaceBrightness::Compare(const IndexedStripes& stripes, const Context& context) {
  const cv::Mat1b whole_part =
      Shrunk(inside_, std::max(0, kWholeInside - options_.margin_px), cv::MORPH_RECT);
  struct OfLaser {
    std::map<int, float> strength;
    std::vector<RatioSample> samples;
  };
  std::vector<OfLaser> lasers(stripes.lasers.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(lasers.size()), [&](std::int64_t n) {
    OfLaser& out = lasers[static_cast<std::size_t>(n)];
    for (auto& [order, samples] : SamplesByOrder(stripes.lasers[static_cast<std::size_t>(n)])) {
      std::vector<float> whole;
      for (const RatioSample& s : samples) {
        if (whole_part(static_cast<int>(s.v), static_cast<int>(s.u)) != 0) whole.push_back(s.ratio);
      }
      if (whole.size() < kLeastRows) continue;
      const float strength = out.strength[order] = Median(std::move(whole));
      for (RatioSample s : samples) {
        s.ratio -= strength;
        out.samples.push_back(s);
      }
    }
  });
  std::vector<RatioSample> all;
  for (std::size_t n = 0; n < lasers.size(); ++n) {
    for (const auto& [order, strength] : lasers[n].strength)
      strength_[{stripes.lasers[n].laser, order}] = static_cast<double>(strength);
    all.insert(all.end(), lasers[n].samples.begin(), lasers[n].samples.end());
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

std::optional<double> SurfaceBrightness::RatioOf(double strength, const StripePoint& point,
                                                 double width_px) const {
  const cv::Point at(cvRound(point.u), cvRound(point.v));
  if (!part_.contains(at) || point.peak >= kClippedPeak) return std::nullopt;
  // Light at a step comes from its bright side.
  const float* level = level_[at.y - part_.y];
  const std::uint8_t* inside = inside_[at.y - part_.y];
  const auto centre = point.u - static_cast<float>(part_.x), last = static_cast<float>(part_.width - 1);
  const auto level_at = [&](float x) {
    x = std::clamp(x, 0.0F, last);
    const int left = static_cast<int>(x), right = std::min(left + 1, part_.width - 1);
    return level[left] + (x - static_cast<float>(left)) * (level[right] - level[left]);
  };
  const auto reach = static_cast<float>(1.2 * width_px);
  float brightest = 0.0F;
  for (float x = std::max(centre - reach, -0.5F); x <= std::min(centre + reach, last + 0.49F); x += 0.5F) {
    const int column = cvRound(x);
    if (inside[std::clamp(column, 0, part_.width - 1)] != 0) brightest = std::max(brightest, level_at(x));
  }
  if (brightest == 0.0F) brightest = level_at(centre);
  return std::log(std::max(1.0, static_cast<double>(point.peak))) - static_cast<double>(brightest) - strength;
}

std::optional<double> SurfaceBrightness::Along(double u, int v, int first, int last, float* gain) const {
  // The columns that are within the part.
  const int low = std::max(first, part_.x), high = std::min(last, part_.x + part_.width - 1);
  const bool crosses = v >= part_.y && v < part_.y + part_.height && low <= high;
  const std::uint8_t* inside = crosses ? inside_[v - part_.y] - part_.x : nullptr;
  // The column that the others are measured against: the nearest to u that is known.
  const int nearest = cvRound(u);
  int middle = std::clamp(nearest, first, last);
  const auto is_known = [&](int x) { return crosses && x >= low && x <= high && inside[x] != 0; };
  for (int away = 0; away <= last - first && !is_known(middle); ++away) {
    const int next = nearest + (away % 2 == 0 ? 1 : -1) * (away / 2 + 1);
    if (is_known(next)) middle = next;
  }
  if (!is_known(middle)) {
    std::fill(gain, gain + (last + 1 - first), 1.0F);
    return std::nullopt;
  }
  std::fill(gain, gain + (low - first), 0.0F);
  std::fill(gain + (high + 1 - first), gain + (last + 1 - first), 0.0F);
  const float *level = level_[v - part_.y] - part_.x, there = level[middle];
  const RatioSlope slope = ratio_.At(u - part_.x, v - part_.y, static_cast<double>(there));
  const auto of_level = static_cast<float>(1.0 + slope.of_level), along_u = static_cast<float>(slope.along_u);
  for (int x = low; x <= high; ++x) {
    const float change = of_level * (level[x] - there) + along_u * static_cast<float>(x - middle);
    gain[x - first] = std::clamp(change, -3.0F, 3.0F);
  }
  RaiseToExp({gain + (low - first), gain + (high + 1 - first)});
  for (int x = low; x <= high; ++x) {
    if (inside[x] == 0) gain[x - first] = 0.0F;
  }
  return static_cast<double>(there);
}

}  // namespace dorsum
