// SPDX-License-Identifier: Apache-2.0
#include "stripes/local_polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>

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

LocalEstimate FitLocally(const StripeCurve& curve, std::size_t first, std::size_t last, std::size_t k,
                         const RowCorrelation& correlation) {
  LocalEstimate out;
  std::array<double, 5> s{};
  Vector3 right{};
  const double scale = 1.0 / std::max(1e-6, 0.5 * (curve.angle[last] - curve.angle[first]));
  int count = 0;
  for (std::size_t i = first; i <= last; ++i) {
    if (curve.use[i] == 0) continue;
    const double w = 1.0 / (curve.sd[i] * curve.sd[i]), t = (curve.angle[i] - curve.angle[k]) * scale;
    const double wt = w * t, wtt = wt * t;
    s[0] += w;
    s[1] += wt;
    s[2] += wtt;
    s[3] += wtt * t;
    s[4] += wtt * t * t;
    right[0] += w * curve.u[i];
    right[1] += wt * curve.u[i];
    right[2] += wtt * curve.u[i];
    ++count;
  }
  std::array<Vector3, 3> inverse{};
  if (count < 5 || !InvertMoments(s, &inverse)) return out;
  const Vector3& c = inverse[0];
  out.u = c[0] * right[0] + c[1] * right[1] + c[2] * right[2];
  // The estimate is a sum of g_i u_i. Its variance is sum g_i^2 s_i^2 + 2 share sum_i g_i s_i S_i, where S_i
  // gathers the earlier rows' g s, each shrunk by `decay` per row.
  double variance = 0.0, earlier = 0.0, row = curve.v[first];
  for (std::size_t i = first; i <= last; ++i) {
    if (curve.use[i] == 0) continue;
    const double t = (curve.angle[i] - curve.angle[k]) * scale;
    const double g = (c[0] + t * (c[1] + t * c[2])) / curve.sd[i];  // weight times deviation
    for (; row < curve.v[i] - 0.5; row += 1.0) earlier *= correlation.decay;
    variance += g * (g + 2.0 * correlation.share * earlier);
    earlier += g;
  }
  out.sd = std::sqrt(std::max(variance, 1e-12));
  out.ok = true;
  return out;
}

}  // namespace dorsum
