// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/camera.h"
#include "geometry/mesh.h"
#include "surface/height_field.h"
#include "surface/surface_point.h"

namespace dorsum {

struct RobustFusionOptions {
  double pitch_mm = 0.5;    // of the height field and, on the object, of the mesh, 0.1 to 5
  double stiffness = 15.0;  // weight of the squared curvature against the samples, mm^-2 mm^2
  double max_distance_mm =
      6.5;  // how far from a point the surface goes on; gaps up to twice as wide close, 0.5 to 50
  double max_slope_deg = 81.0;  // against the image plane; steeper is a depth jump and stays open, 10 to 89
  double outlier_mm = 2.0;      // a point further than this and than
  double outlier_sigmas = 8.0;  // that many of its sigma from the surface of the others is an outlier
};

enum class PointVerdict : std::uint8_t { kGood, kOutlier, kOutsideSupport };

struct RobustFusion {
  HeightField field;
  TriangleMesh mesh;
  std::vector<PointVerdict> verdicts;  // one per point
  int outliers = 0;
};

// Merges the points of all lasers into one surface, solved over the image, where the seen surface is a
// function, its outline is the mask's, and what hides behind an edge needs no care: a thin plate (plate.h)
// with the points' variances as weights and Geman-McClure's weights against outliers, from coarse to fine, on
// top of the rim term (rim.h) that lets flanks fall as steeply as rounded bodies do. The mesh is cut at the
// outline, and the height field is the mesh seen from above. `mask`: CV_8UC1, not 0 on the object, of the
// captured image's size.
RobustFusion FuseRobust(const SurfacePoints& points, const Camera& camera, const cv::Mat& mask,
                        const RobustFusionOptions& options, const Context& context = {});

}  // namespace dorsum
