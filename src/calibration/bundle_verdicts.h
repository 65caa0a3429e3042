// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "calibration/bundle_calibration.h"

namespace dorsum {

// What each part says of itself: camera, chessboard, planes of known height, and each laser with its sheets.
std::vector<PartReport> JudgeBundle(const BundleCalibration& calibration,
                                    const BundleVerdictOptions& options);

// Whether a check goes beyond what chance and a careful hand explain.
bool HeightIsWrong(const HeightCheck& check, const BundleVerdictOptions& options);
bool BoardIsBent(const BoardCheck& check, const BundleVerdictOptions& options);

// Where the solution sees the corners of each board view, px, in the order of BoardView::corners.
std::vector<std::vector<Eigen::Vector2d>> ExpectedCorners(const BundleData& data, const BundleState& state);

// Root mean square distance of each board view's corners from where the solution sees them, px.
std::vector<double> ViewErrors(const BundleData& data, const BundleState& state);

}  // namespace dorsum
