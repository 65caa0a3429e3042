// SPDX-License-Identifier: Apache-2.0
#include "simulator/gloss.h"

#include <algorithm>
#include <cmath>

namespace dorsum {

double Highlight(const SurfaceSample& sample, const Eigen::Vector3d& light, const Eigen::Vector3d& eye) {
  if (sample.gloss <= 0.0F) return 0.0;
  const Eigen::Vector3d in = (light - sample.position).normalized();
  const Eigen::Vector3d half = (in + (eye - sample.position).normalized()).normalized();
  const double cosine = sample.normal.cast<double>().dot(half);
  if (cosine <= 0.0) return 0.0;
  const double n = sample.shininess, gloss = sample.gloss;
  const double fresnel = gloss + (1.0 - gloss) * std::pow(1.0 - std::clamp(in.dot(half), 0.0, 1.0), 5.0);
  return fresnel * (n + 8.0) / 8.0 * std::pow(cosine, n);
}

}  // namespace dorsum
