// SPDX-License-Identifier: Apache-2.0
#include "simulator/swept_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dorsum {
namespace {

constexpr double kStep = 0.5;  // mm between the profile's samples
constexpr int kRow = 5;

// Slopes of the monotone piecewise cubic through (s, y): harmonic means of neighbouring secants, which never
// overshoot (Fritsch and Carlson 1980).
std::vector<double> MonotoneSlopes(const std::vector<double>& s, const std::vector<double>& y) {
  const std::size_t n = s.size();
  std::vector<double> slopes(n, 0.0);
  auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (s[i + 1] - s[i]); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double a = secant(i - 1), b = secant(i);
    if (a * b <= 0) continue;
    const double left = s[i] - s[i - 1], right = s[i + 1] - s[i];
    slopes[i] = 3 * (left + right) / ((2 * right + left) / a + (right + 2 * left) / b);
  }
  slopes[0] = secant(0);
  slopes[n - 1] = secant(n - 2);
  return slopes;
}

double Hermite(double s0, double s1, double y0, double y1, double m0, double m1, double s) {
  const double h = s1 - s0, t = (s - s0) / h;
  return y0 * (1 + 2 * t) * (1 - t) * (1 - t) + h * m0 * t * (1 - t) * (1 - t) + y1 * t * t * (3 - 2 * t) -
         h * m1 * t * t * (1 - t);
}

std::vector<double> Sampled(const std::vector<double>& s, const std::vector<double>& y, double from,
                            int count) {
  const std::vector<double> slopes = MonotoneSlopes(s, y);
  std::vector<double> samples(count);
  for (int k = 0; k < count; ++k) {
    const double at = std::clamp(from + k * kStep, s.front(), s.back());
    std::size_t i = std::upper_bound(s.begin(), s.end(), at) - s.begin();
    i = std::clamp<std::size_t>(i, 1, s.size() - 1);
    samples[k] = Hermite(s[i - 1], s[i], y[i - 1], y[i], slopes[i - 1], slopes[i], at);
  }
  return samples;
}

std::vector<double> Blurred(const std::vector<double>& samples, double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma / kStep));
  if (reach == 0) return samples;
  const int n = static_cast<int>(samples.size());
  std::vector<double> blurred(samples.size());
  for (int k = 0; k < n; ++k) {
    double sum = 0, weight = 0;
    for (int d = -reach; d <= reach; ++d) {
      const double w = std::exp(-0.5 * std::pow(d * kStep / sigma, 2));
      sum += w * samples[std::clamp(k + d, 0, n - 1)];
      weight += w;
    }
    blurred[k] = sum / weight;
  }
  return blurred;
}

}  // namespace

SweptBody::SweptBody(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                     const std::vector<SweptSection>& sections, const SweptBodyOptions& options)
    : along_(direction.normalized()), left_(-along_.y(), along_.x()), options_(options) {
  if (sections.size() < 2) throw std::logic_error("a swept body needs two sections");
  origin_ = origin;
  first_ = sections.front().s;
  last_ = sections.back().s;
  cos_roll_ = std::cos(options.roll);
  sin_roll_ = std::sin(options.roll);

  std::vector<double> s;
  std::array<std::vector<double>, kRow> columns;
  for (const SweptSection& section : sections) {
    if (!s.empty() && section.s <= s.back()) throw std::logic_error("sections must be in order");
    s.push_back(section.s);
    const Row row = {section.offset, section.z, section.half_breadth, section.dorsal, section.palmar};
    for (int c = 0; c < kRow; ++c) columns[c].push_back(row[c]);
  }
  const double from = first_ - options.near_cap;
  const int count = static_cast<int>(std::ceil((last_ + options.far_cap - from) / kStep)) + 4;
  for (auto& column : columns) column = Blurred(Sampled(s, column, from, count), options.smoothing);

  table_.resize(count);
  box_lo_ = Eigen::Vector3d(from, 1e9, 1e9);
  box_hi_ = Eigen::Vector3d(last_ + options.far_cap, -1e9, -1e9);
  for (int k = 0; k < count; ++k) {
    const int before = std::max(k - 1, 0), after = std::min(k + 1, count - 1);
    const double run = (after - before) * kStep;
    const double sideways = (columns[0][after] - columns[0][before]) / run;
    const double upwards = (columns[1][after] - columns[1][before]) / run;
    Row& row = table_[k];
    for (int c = 0; c < kRow; ++c) row[c] = columns[c][k];
    row[2] *= std::sqrt(1 + sideways * sideways);
    row[3] *= std::sqrt(1 + upwards * upwards);
    row[4] *= std::sqrt(1 + upwards * upwards);
    const double deepest = std::max(row[3], row[4]);
    const double c = std::abs(cos_roll_), d = std::abs(sin_roll_);
    const double wide = c * row[2] + d * deepest, high = d * row[2] + c * deepest;
    box_lo_.y() = std::min(box_lo_.y(), row[0] - wide);
    box_hi_.y() = std::max(box_hi_.y(), row[0] + wide);
    box_lo_.z() = std::min(box_lo_.z(), row[1] - high);
    box_hi_.z() = std::max(box_hi_.z(), row[1] + high);
  }
}

SweptBody::Row SweptBody::ProfileAt(double s) const {
  const double position = std::clamp((s - (first_ - options_.near_cap)) / kStep, 1.0, table_.size() - 3.0);
  const auto i = static_cast<std::size_t>(position);
  const double t = position - i, t2 = t * t, t3 = t2 * t;
  const double w0 = (1 - 3 * t + 3 * t2 - t3) / 6, w1 = (4 - 6 * t2 + 3 * t3) / 6;
  const double w3 = t3 / 6, w2 = 1 - w0 - w1 - w3;
  const Row &a = table_[i - 1], &b = table_[i], &c = table_[i + 1], &d = table_[i + 2];
  Row row;
  for (int k = 0; k < kRow; ++k) row[k] = w0 * a[k] + w1 * b[k] + w2 * c[k] + w3 * d[k];
  return row;
}

SweptBody::Place SweptBody::Locate(const Eigen::Vector3d& point) const {
  Place place = {};
  const Eigen::Vector2d flat = point.head<2>() - origin_;
  const Eigen::Vector3d local(flat.dot(along_), flat.dot(left_), point.z());
  place.outside = (box_lo_ - local).cwiseMax(local - box_hi_).cwiseMax(0.0).norm();
  if (place.outside > kFar) return place;
  const Row row = ProfileAt(local.x());
  place.s = local.x();
  const double across = local.y() - row[0], above = local.z() - row[1];
  place.u = cos_roll_ * across - sin_roll_ * above;
  place.v = sin_roll_ * across + cos_roll_ * above;
  place.half_breadth = row[2];
  place.half_depth = place.v >= 0 ? row[3] : row[4];
  if (local.x() < first_) place.cap = (first_ - local.x()) / options_.near_cap;
  if (local.x() > last_) place.cap = (local.x() - last_) / options_.far_cap;
  return place;
}

double SweptBody::DistanceAt(const Place& place) const {
  if (place.outside > kFar) return place.outside;
  const double cap_length = place.s < first_ ? options_.near_cap : options_.far_cap;
  // F = (|x/a|^p + |y/b|^p + |z/c|^p)^(1/p) is 1 on the body; (F - 1) / |grad F| is the distance to first
  // order.
  const double p = options_.exponent;
  const double terms[3] = {place.cap, std::abs(place.u) / place.half_breadth,
                           std::abs(place.v) / place.half_depth};
  const double scales[3] = {cap_length, place.half_breadth, place.half_depth};
  double sum = 0, slope = 0;
  for (int k = 0; k < 3; ++k) {
    if (terms[k] < 1e-9) continue;
    const double power = p == 2.0   ? terms[k]
                         : p == 2.5 ? terms[k] * std::sqrt(terms[k])
                                    : std::pow(terms[k], p - 1);
    sum += power * terms[k];
    slope += (power / scales[k]) * (power / scales[k]);
  }
  if (sum < 1e-12) return -std::min(place.half_breadth, place.half_depth);
  const double f = p == 2.0 ? std::sqrt(sum) : std::pow(sum, 1 / p);
  return (f - 1) * (sum / f) / std::sqrt(slope);  // |grad F| = sqrt(slope) * F^(1-p), and sum / F = F^(p-1)
}

void SweptBody::GrowBounds(Eigen::Vector3d& lo, Eigen::Vector3d& hi, double margin) const {
  for (int corner = 0; corner < 4; ++corner) {
    const double s = corner & 1 ? box_hi_.x() : box_lo_.x(), l = corner & 2 ? box_hi_.y() : box_lo_.y();
    const Eigen::Vector2d flat = origin_ + s * along_ + l * left_;
    lo.head<2>() = lo.head<2>().cwiseMin((flat.array() - margin).matrix());
    hi.head<2>() = hi.head<2>().cwiseMax((flat.array() + margin).matrix());
  }
  lo.z() = std::min(lo.z(), box_lo_.z() - margin);
  hi.z() = std::max(hi.z(), box_hi_.z() + margin);
}

}  // namespace dorsum
