// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "geometry/ray.h"

namespace dorsum {

// How the fan of a line laser meets its grating (DESIGN §3): what alpha before the grating is,
// sin(tilt) + turn * beta + bow * (sqrt(1 - beta^2) - 1), whose terms of second order in beta are the
// general a0 + a1 beta + a2 beta^2.
enum class FanForm {
  kFlat,     // the fan is a plane, as it leaves a laser: bow = sin(tilt), whatever `bow` says
  kConical,  // without turn alpha is the same for all rays: bow = 0, whatever `bow` says
  kGeneral,  // `bow` as it is, which calibration finds
};

// A line laser behind a diffraction grating. In the grating's frame, a ray that meets it with direction
// cosines (alpha, beta, gamma) leaves in order m with (alpha + m * step, beta, sqrt(1 - alpha'^2 - beta^2)).
// The fan starts `fan_distance_mm` behind the grating, so rays leave from (turn * y_g, y_g, 0) with
// y_g = fan_distance * beta / gamma. Order m therefore sweeps out a cone about the grating's axis a.
struct DiffractedFan {
  Eigen::Vector3d origin =
      Eigen::Vector3d::Zero();  // point of the grating that the fan's middle ray meets, world, mm
  Eigen::Vector3d a = Eigen::Vector3d::UnitX();  // unit, in the grating: the direction in which orders spread
  Eigen::Vector3d b = -Eigen::Vector3d::UnitY();  // unit, in the grating: along the laser line
  Eigen::Vector3d n = -Eigen::Vector3d::UnitZ();  // unit, the grating's normal towards the scene
  double fan_distance_mm = 0.0;
  double tilt = 0.0;  // rad, angle between the fan's middle ray and n, towards a
  double turn = 0.0;  // rad, of the fan against the grating's own b, about n
  double bow = 0.0;   // of kGeneral only: alpha's curvature along the fan
  double step = 0.0;  // lambda / d times the projection of the grating's axis on the baseline (§2.5)
  FanForm form = FanForm::kFlat;
};

// Where a world point lies in the light of a fan.
struct FanCoordinates {
  double alpha = 0.0;     // direction cosine along a of the ray through the point, after the grating
  double beta = 0.0;      // direction cosine along b, the same before and after
  double alpha_in = 0.0;  // direction cosine along a before the grating, for this beta
  Eigen::Vector3d exit = Eigen::Vector3d::Zero();  // where the ray leaves the grating, world, mm
  double distance_mm = 0.0;                        // from there to the point

  // The diffraction order as a real number; a whole number means that the point is on a light sheet's middle.
  double Order(const DiffractedFan& fan) const { return (alpha - alpha_in) / fan.step; }
};

// Finds the ray of the fan that reaches a world point, whatever its order; none for points behind the
// grating.
std::optional<FanCoordinates> Locate(const DiffractedFan& fan, const Eigen::Vector3d& world);

// The factor of (sqrt(1 - beta^2) - 1) that the fan's form asks for.
double EffectiveBow(const DiffractedFan& fan);

// alpha before the grating of the ray with direction cosine beta.
double IncomingAlpha(const DiffractedFan& fan, double beta);

// The ray of order m with direction cosine beta, as it leaves the grating; none where the order does not
// propagate.
std::optional<Ray> DiffractedRay(const DiffractedFan& fan, int order, double beta);

}  // namespace dorsum
