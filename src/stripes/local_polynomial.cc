// SPDX-License-Identifier: Apache-2.0
#include "stripes/local_polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace dorsum {
namespace {

using Vector3 = std::array<double, 3>;

// Inverse of the symmetric 3 x 3 matrix of the moments s0 ... s4, by its adjugate; false if it is singular.
bool InvertMoments(const std::array<double, 5>& s, std::array<Vector3, 3>* inverse) {
  const double a = s[2] * s[4] - s[3] * s[3], b = s[2] * s[3] - s[1] * s[4], c = s[1] * s[3] - s[2] * s[2];
  const double determinant = s[0] * a + s[1] * b + s[2] * c;
  if (!(determinant > 1e-9 * s[0] * s[2] * s[4])) return false;
  const double d = s[0] * s[4] - s[2] * s[2], e = s[1] * s[2] - s[0] * s[3], f = s[0] * s[2] - s[1] * s[1];
  *inverse = {Vector3{a / determinant, b / determinant, c / determinant},
              Vector3{b / determinant, d / determinant, e / determinant},
              Vector3{c / determinant, e / determinant, f / determinant}};
  return true;
}

}  // namespace

std::vector<StripeCurve> CurvesOf(const LaserStripes& stripes) {
  std::vector<StripeCurve> curves;
  curves.reserve(stripes.segments.size());
  for (const StripeSegment& segment : stripes.segments) {
    const auto count = static_cast<std::size_t>(segment.count);
    StripeCurve& curve = curves.emplace_back();
    for (auto* values : {&curve.v, &curve.u, &curve.sd, &curve.weight}) values->reserve(count);
    curve.use.assign(count, 1);
    for (std::int32_t i = segment.first; i < segment.first + segment.count; ++i) {
      const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
      const double sd = std::max(1e-3, static_cast<double>(p.sd_px));
      curve.v.push_back(static_cast<double>(p.v));
      curve.u.push_back(static_cast<double>(p.u));
      curve.sd.push_back(sd);
      curve.weight.push_back(1.0 / (sd * sd));
    }
  }
  return curves;
}

void MeasureAngles(StripeCurve* curve) {
  const double from = curve->v.front() - 0.5, length = curve->v.back() + 0.5 - from;
  curve->angle.reserve(curve->v.size());
  for (const double v : curve->v) curve->angle.push_back(std::acos(1.0 - 2.0 * (v - from) / length));
}

void LocalQuadratic::Add(std::size_t i) {
  if (curve_.use[i] == 0) return;
  const double w = curve_.weight[i], t = curve_.angle[i] - curve_.angle[k_];
  const double wt = w * t, wtt = wt * t, wttt = wtt * t, u = curve_.u[i];
  moments_[0] += w;
  moments_[1] += wt;
  moments_[2] += wtt;
  moments_[3] += wttt;
  moments_[4] += wttt * t;
  right_[0] += w * u;
  right_[1] += wt * u;
  right_[2] += wtt * u;
  ++count_;
}

void LocalQuadratic::Widen(std::size_t first, std::size_t last) {
  while (first_ > first) Add(--first_);
  for (; end_ <= last; ++end_) Add(end_);
}

LocalEstimate LocalQuadratic::Estimate(const RowCorrelation& correlation) const {
  LocalEstimate out;
  if (count_ < 5) return out;
  const std::size_t last = end_ - 1;
  // In half windows, so that the moments are of one size.
  const double scale = 1.0 / std::max(1e-6, 0.5 * (curve_.angle[last] - curve_.angle[first_]));
  std::array<double, 5> s = moments_;
  double power = 1.0;
  for (double& one : s) {
    one *= power;
    power *= scale;
  }
  std::array<Vector3, 3> inverse{};
  if (!InvertMoments(s, &inverse)) return out;
  const Vector3 c = {inverse[0][0], inverse[0][1] * scale, inverse[0][2] * scale * scale};
  out.u = c[0] * right_[0] + c[1] * right_[1] + c[2] * right_[2];
  // The estimate is a sum of g_i u_i. Its variance is sum g_i^2 s_i^2 + 2 share sum_i g_i s_i S_i, where S_i
  // gathers the earlier rows' g s, each shrunk by `decay` per row.
  double variance = 0.0, earlier = 0.0, row = curve_.v[first_];
  for (std::size_t i = first_; i <= last; ++i) {
    if (curve_.use[i] == 0) continue;
    const double t = curve_.angle[i] - curve_.angle[k_];
    const double g = (c[0] + t * (c[1] + t * c[2])) * curve_.sd[i] * curve_.weight[i];  // times deviation
    for (; row < curve_.v[i] - 0.5; row += 1.0) earlier *= correlation.decay;
    variance += g * (g + 2.0 * correlation.share * earlier);
    earlier += g;
  }
  out.sd = std::sqrt(std::max(variance, 1e-12));
  out.ok = true;
  return out;
}

}  // namespace dorsum
