// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "geometry/rigid3.h"

namespace dorsum {

// A number from one of OpenCV's solvers in single precision. OpenCV leaves its matrix products to whatever
// BLAS is installed, whose last digits vary with its version and the number of its threads; a calibration
// that starts from numbers without those digits does not.
inline double Settled(double value) { return static_cast<double>(static_cast<float>(value)); }

// The pose that a rotation vector and a translation (3 numbers of type double each) of a solver mean,
// settled.
Rigid3 PoseFromSolver(const cv::Mat& rvec, const cv::Mat& tvec);

}  // namespace dorsum
