// SPDX-License-Identifier: Apache-2.0
#include "accuracy/plane_alignment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "accuracy/statistics.h"

namespace dorsum::accuracy {

PlaneAlignment AlignInPlane(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b) {
  if (a.size() != b.size()) throw std::logic_error("AlignInPlane: points without partners");
  PlaneAlignment out;
  std::vector<char> keep(a.size(), 1);
  std::vector<double> residuals(a.size());
  for (int round = 0; round < 3; ++round) {
    Eigen::Vector2d mean_a = Eigen::Vector2d::Zero(), mean_b = Eigen::Vector2d::Zero();
    double n = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (keep[i] == 0) continue;
      mean_a += a[i];
      mean_b += b[i];
      n += 1.0;
    }
    if (n == 0.0) break;
    mean_a /= n;
    mean_b /= n;
    double cosine = 0.0, sine = 0.0;  // of the best angle, both times the same factor
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (keep[i] == 0) continue;
      const Eigen::Vector2d p = a[i] - mean_a, q = b[i] - mean_b;
      cosine += p.dot(q);
      sine += p.x() * q.y() - p.y() * q.x();
    }
    const double angle = std::atan2(sine, cosine);
    out.rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    out.shift = mean_b - out.rotation * mean_a;
    for (std::size_t i = 0; i < a.size(); ++i) {
      residuals[i] = (out.rotation * a[i] + out.shift - b[i]).norm();
    }
    const double limit = std::max(3.0 * Quantile(residuals, 0.5), 1e-6);
    for (std::size_t i = 0; i < a.size(); ++i) keep[i] = residuals[i] < limit ? 1 : 0;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (keep[i] != 0) out.residuals.push_back(residuals[i]);
  }
  return out;
}

}  // namespace dorsum::accuracy
