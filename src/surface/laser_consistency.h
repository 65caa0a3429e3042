// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "base/context.h"
#include "surface/plate.h"
#include "surface/plate_stack.h"
#include "surface/ray_field.h"
#include "surface/rim.h"

namespace dorsum {

struct LaserConsistencyOptions {
  double mm_per_px = 0.2;  // of the object, above 0
  double max_apart_mm =
      7.0;  // a sample further than this from those of all other lasers is not compared, above 0
  double patch_mm = 8.0;        // side of the patches whose errors count as independent, above 0
  double prior_shift_mm = 5.0;  // standard deviation of a shift before anything was seen, above 0
  int min_samples = 100;        // of a laser that can be compared
};

// How one laser's samples lie against the surface that all others make.
struct LaserConsistency {
  int laser = 0;
  int samples = 0;                             // that could be compared; 0: the rest is not known
  double offset_mm = 0.0, offset_sd_mm = 0.0;  // in height
  Eigen::Vector3d shift_mm =
      Eigen::Vector3d::Zero();  // of the object between the others' images and this one's
  Eigen::Vector3d shift_sd_mm = Eigen::Vector3d::Zero();
  double shift_significance = 0.0;  // length of the shift in its own standard deviations (Mahalanobis)
  double chi2 = 0.0;  // robust: squared ratio of the samples' spread about the others' surface to what it
                      // should be; 1 is right
};

// For each laser, solves the surface of all others on `fused` and compares: residuals along the normal,
// e = n . (p - q), give the rigid shift t = argmin sum rho(e - n . t) (one step of point-to-plane alignment,
// Chen & Medioni 1992) and, with t along z alone, the height offset. What a residual may be without any shift
// is learnt from all lasers by the distance to the nearest other stripe. Standard deviations come from the
// scatter between patches (White's sandwich), since neighbouring residuals are not independent. `lasers`: one
// per sample; `fused`: the solved lattice and the coarser ones (MakeGrids).
std::vector<LaserConsistency> CompareLasers(const std::vector<PlateSample>& samples,
                                            const std::vector<std::uint8_t>& lasers,
                                            std::span<const PlateGrid> fused, const PlateOptions& plate,
                                            const Rim& rim, const RayField& rays,
                                            const LaserConsistencyOptions& options,
                                            const Context& context = {});

}  // namespace dorsum
