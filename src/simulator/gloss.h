// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "simulator/view.h"

namespace dorsum {

// Light that a glossy surface mirrors from `light` to `eye`, per irradiance, in the units of an albedo: a
// white matt surface gives 1. Normalised Blinn-Phong lobe around the half-way vector h,
//   F(i.h) (n + 8) / 8 (normal.h)^n   with n the shininess,
// and Schlick's Fresnel term F = gloss + (1 - gloss) (1 - i.h)^5.
double Highlight(const SurfaceSample& sample, const Eigen::Vector3d& light, const Eigen::Vector3d& eye);

}  // namespace dorsum
