// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_model.h"

namespace dorsum {

// One picture of the chessboard.
struct BoardView {
  std::string name;
  std::vector<Eigen::Vector2d> corners;  // px, one per board point
  int plane = -1;                        // index of the plane on which the board lies; -1: held freely
};

// A plane's sd_mm that means that its height is not known at all.
inline constexpr double kUnknownHeightSd = 100.0;

// A plane of known height: the backplane, the calibration object's top, a box's top.
struct HeightPlane {
  std::string name;
  double given_mm = 0.0;
  double sd_mm = 0.0;  // how well the height is known; 0: exactly, and level
};

// Where a stripe of known order crosses an image row on a plane of known height.
struct SheetPoint {
  int laser = 0;   // index into the fans
  int source = 0;  // index of the picture it was seen in
  int plane = 0;   // index into the planes
  int order = 0;
  double u = 0.0, v = 0.0;     // px
  double sd_px = 0.0;          // one standard deviation of u
  double orders_per_px = 0.0;  // size of d(order)/du on that plane
  double peak = 0.0;           // brightness, grey values
  double mm_per_px = 0.0;      // size of dx/du on that plane
};

struct BundleData {
  std::vector<Eigen::Vector3d> board_points;  // mm, y against the image's v, centre 0
  std::vector<BoardView> boards;              // the first one fixes the world
  std::vector<HeightPlane> planes;            // the first one is the backplane
  std::vector<SheetPoint> points;
};

// All parameters of one device and its series.
struct BundleState {
  int width = 0, height = 0;  // px
  LensParameters lens;
  PoseParameters camera_from_world;
  std::vector<PoseParameters> world_from_board;
  std::vector<std::array<double, kPlaneSize>> planes;
  std::vector<FanParameters> fans;
  std::array<double, kBoardBowSize> board_bow{};

  Camera GetCamera() const { return CameraFromParameters(lens, camera_from_world, width, height); }
};

struct BundleProblemOptions {
  bool move_camera = true;    // lens, camera and boards
  bool use_points = true;     // fans and planes
  bool bow_boards = false;    // one common sag of the board
  bool free_heights = false;  // planes' heights without their priors, as far as boards or stripes tell them
  double corner_sd_px = 0.1;
  double lying_sd_mm = 0.05;     // how flat a board lies on its plane: height of its centre
  double lying_sd_rad = 0.0005;  // and its slopes
  double point_sd_px = 0.03;     // added to each stripe point's own sd in quadrature
  double loss_scale = 3.0;       // residuals beyond that many sd count less (Cauchy)
  int max_iterations = 60;
  bool uncertainties = false;
};

struct BundleSolution {
  BundleState state;
  double cost = 0.0;
  double variance_factor = 1.0;  // weighted sum of squares over the degrees of freedom
  // Covariance of [lens, camera pose, fans], in the state's order, scaled by the variance factor; empty when
  // not asked for.
  Eigen::MatrixXd covariance;
  std::vector<double> height_sd;  // of each plane's height, mm, when asked for; 0 where it was fixed
};

// Least squares over the chessboards' corners and the stripes on planes of known height: a bundle adjustment
// by Levenberg and Marquardt with Cauchy's loss and one dense normal matrix, since points are many and
// parameters few; the same bytes at any number of threads. A stripe point's residual is the fraction by
// which the order of the fan through it misses a whole number, in units of its sd. Weak priors hold what the
// data leave open: the split between a fan's tilt and its turn about b, its turn about a against its place
// along y, and its skew against its turn about n.
Result<BundleSolution> SolveBundle(const BundleData& data, const BundleState& start,
                                   const BundleProblemOptions& options, const Context& context);

// What a stripe point leaves: order minus the whole number it should be.
double OrderMiss(const BundleState& state, const SheetPoint& point);

}  // namespace dorsum
