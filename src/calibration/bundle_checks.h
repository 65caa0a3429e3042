// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/bundle_problem.h"

namespace dorsum {

// A height as it was given and as everything else has it.
struct HeightCheck {
  int plane = 0;
  double given_mm = 0.0, fitted_mm = 0.0, sd_mm = 0.0;
};

// Solves once more with all heights free. `options` are those of the solution.
Result<std::vector<HeightCheck>> CheckHeights(const BundleData& data, const BundleState& state,
                                              const BundleProblemOptions& options, const Context& context);

// How much the board's corners lie off a plane (x^2, xy, y^2 over its half sides), and how sure that is.
struct BoardCheck {
  double sag_mm = 0.0;        // corners against the centre, the worst of the four
  double significance = 0.0;  // in standard deviations
  std::array<double, kBoardBowSize> bow{};
};

// From the boards alone.
Result<BoardCheck> CheckBoard(const BundleData& data, const BundleState& state,
                              const BundleProblemOptions& options, const Context& context);

// What all other pictures of a laser predict for one: how far its stripes lie off there.
struct SeriesCheck {
  int laser = 0, source = 0;
  double off_mm = 0.0;  // on the plane: root mean square of the shift, slope and stretch that fits the misses
  double rest_sd = 0.0;  // what the other pictures leave without this one, in their own sd
};

// Leaves out each picture of each laser in turn and fits the laser's fan to the others (camera and planes
// stay). Pictures whose absence leaves fewer than two heights cannot be checked so, and are not in the list.
Result<std::vector<SeriesCheck>> CheckSeries(const BundleData& data, const BundleState& state,
                                             const BundleProblemOptions& options, const Context& context);

// One standard deviation of the heights that calibration alone causes, over the image and the heights given;
// `covariance` as in BundleSolution.
double HeightUncertainty(const BundleState& state, const Eigen::MatrixXd& covariance, int fan, int min_order,
                         int max_order, double min_height_mm, double max_height_mm);

// Pattern along a laser's stripes and over its orders that the model leaves on planes of all heights, root
// mean square, mm on the plane: the mean residuals of stretches of y are multiplied with those of the next
// order, whose noise is another while a model's error is nearly the same.
struct PatternPoint {
  int order = 0;
  double y_mm = 0.0, height_mm = 0.0, miss_mm = 0.0;
};
double LeftPattern(const std::vector<PatternPoint>& points);

}  // namespace dorsum
