// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "accuracy/capture_truth.h"
#include "accuracy/plane_alignment.h"
#include "accuracy/statistics.h"
#include "geometry/mesh.h"
#include "surface/surface_point.h"

namespace dorsum::accuracy {

// A reconstruction held against the truth, mm or shares of 1. All errors are of height, at the image point
// that a stripe point names.
struct PointScore {
  int points = 0, points_on_object = 0;
  double wrong = 0.0;  // share of points on the object more than 2 mm off: a stripe with the wrong order
  ErrorStatistics z;
  double z_rmse_right = 0.0;           // without the wrong ones
  std::map<int, double> z_rmse_laser;  // of lasers with more than 20 points on the object
  int sigma_bad = 0;                   // right points whose sigma is not above zero
  std::optional<double> sigma_ratio;   // rms of error over stated sigma, right points: 1 is honest
  double xy_rmse = 0.0;                // after one rigid alignment in the plane
  double complete = 0.0;               // share of true, lit stripe points found within 1.5 px and 2 mm
  double stray = 0.0;                  // share of points on the object with no true stripe within 3 px
  double beyond = 0.0;                 // share of all points more than 2 px outside the object
  PlaneAlignment alignment;            // from the reconstruction's frame to the true one
};

// The mesh's vertices and the centres of its faces, where the true surface is less steep than about 70
// degrees.
struct SurfaceScore {
  ErrorStatistics z;
  double wrong = 0.0;   // share more than 2 mm off
  double cover = 0.0;   // share of such pixels of the object that the mesh covers
  double beyond = 0.0;  // covered pixels more than 3 px outside the object, as a share of the object's
  int faces = 0;
};

// None when fewer than 50 points lie on the object.
std::optional<PointScore> ScorePoints(const CaptureTruth& truth, const SurfacePoints& points);

// `alignment` as ScorePoints found it. None when fewer than 50 places of the mesh can be judged.
std::optional<SurfaceScore> ScoreSurface(const CaptureTruth& truth, const TriangleMesh& mesh,
                                         const PlaneAlignment& alignment);

// The mask's own errors against the true outline, as shares of the object's pixels.
struct MaskScore {
  double missing = 0.0;  // pixels of the object, more than 1 px inside its outline, that the mask leaves out
  double beyond = 0.0;   // pixels of the mask more than 3 px outside the object
};
MaskScore ScoreMask(const CaptureTruth& truth, const cv::Mat1b& mask);

// Figures by the names that the tables and limits use: z_rmse, surface_z_p95_abs, z_rmse_laser0 ...;
// mask_missing and mask_beyond are the mask's.
using Figures = std::map<std::string, double>;
Figures ToFigures(const PointScore& points, const std::optional<SurfaceScore>& surface);

}  // namespace dorsum::accuracy
