// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/camera.h"
#include "geometry/mesh.h"
#include "surface/height_field.h"
#include "surface/laser_consistency.h"
#include "surface/laser_offsets.h"
#include "surface/surface_point.h"

namespace dorsum {

struct RobustFusionOptions {
  double pitch_mm = 0.5;  // of the height field, mm, 0.1 to 5
  // The mesh's vertices lie this many pitches apart on the object, 0.5 to 4: the surface between stripes,
  // which are millimetres apart, needs no more (docs/accuracy.md).
  double pitches_per_node = 1.25;
  double max_beyond_mm = 7.0;   // how far the surface goes on beyond the last points, 0 to 50
  double max_gap_mm = 20.0;     // widest gap between points that closes, 1 to 100
  double max_slope_deg = 81.0;  // against the image plane; steeper is a depth jump and stays open, 10 to 89
  // Residuals beyond it weigh little while the surface is solved, and beyond twice it where lasers are
  // compared, 1 to 100.
  double robust_sigmas = 4.0;
  double outlier_mm = 0.2;      // a point further from the surface than this, 0.1 to 50, and than
  double outlier_sigmas = 4.0;  // that many of its own sigma, 1 to 100, is an outlier
  double offset_sigmas = 3.0;   // a laser's height offset that is this many times its sd, 1 to 100, and
  double max_offset_mm = 0.5;   // not more than this is taken off before merging, 0: never
};

enum class PointVerdict : std::uint8_t {
  kGood,
  kMisplaced,  // its stripe contradicts the stripes around it: a wrong order
  kOutlier,    // off the merged surface
  kUnused,     // outside the mask
};

struct RobustFusion {
  HeightField field;
  TriangleMesh mesh;
  std::vector<PointVerdict> verdicts;    // one per point
  std::vector<LaserConsistency> lasers;  // as the points came, by laser
  std::vector<LaserOffset> offsets;      // relative to the mean of all lasers
  int misplaced = 0, outliers = 0;       // points
};

// Merges the points of all lasers into one surface. It is solved over the image, where the seen surface is a
// function, where its outline is the mask's and what hides behind an edge needs no care: a thin plate
// (plate.h) through the points, gathered by the rows between two nodes (gathered_rows.h), with their
// variances as weights, Geman-McClure's weights against outliers and a stiffness that follows the surface
// (plate_stiffness.h), from coarse to fine, on top of the rim term (rim.h) that lets
// flanks fall as steeply as rounded bodies do. Stripes with wrong orders are found first
// (stripe_agreement.h). Each laser is compared with the surface of the others (laser_consistency.h), and
// offsets in height that are surely there (laser_offsets.h) are taken off. The mesh is cut at the outline;
// the height field is the mesh seen from above. `mask`: CV_8UC1, not 0 on the object, of the captured image's
// size.
RobustFusion FuseRobust(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
                        const RobustFusionOptions& options, const Context& context = {});

}  // namespace dorsum
