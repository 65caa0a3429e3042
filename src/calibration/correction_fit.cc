// SPDX-License-Identifier: Apache-2.0
#include "calibration/correction_fit.h"

#include <cmath>

#include <Eigen/Dense>

namespace dorsum {

Result<CorrectionFit> FitCorrection(const std::vector<HeightSample>& samples) {
  if (samples.size() < 6)
    return BadInput("too few points on the boxes under heights/ to fit the error correction");
  // Coordinates near 1 keep the normal equations well conditioned.
  constexpr double kScaleX = 100.0, kScaleZ = 30.0;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6 right = Vector6::Zero();
  CorrectionFit fit;
  for (const HeightSample& s : samples) {
    const double x = s.x / kScaleX, z = s.z / kScaleZ;
    Vector6 row;
    row << 1.0, x, z, x * x, x * z, z * z;
    row *= s.z;
    normal += row * row.transpose();
    right += row * (s.z - s.h);
    fit.mean_before_mm += s.z - s.h;
    fit.rms_before_mm += std::pow(s.z - s.h, 2);
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal);
  const Vector6 c = solver.solve(right);
  if (solver.info() != Eigen::Success || !c.allFinite() || solver.rcond() < 1e-12) {
    return BadInput(
        "the boxes under heights/ do not determine the error correction; at least three heights are needed");
  }
  fit.polynomial.c = {c[0],
                      c[1] / kScaleX,
                      c[2] / kScaleZ,
                      c[3] / (kScaleX * kScaleX),
                      c[4] / (kScaleX * kScaleZ),
                      c[5] / (kScaleZ * kScaleZ)};
  for (const HeightSample& s : samples) {
    const double error = fit.polynomial.CorrectedZ(s.x, s.z) - s.h;
    fit.mean_after_mm += error;
    fit.rms_after_mm += error * error;
  }
  const auto n = static_cast<double>(samples.size());
  fit.samples = samples.size();
  fit.mean_before_mm /= n;
  fit.mean_after_mm /= n;
  fit.rms_before_mm = std::sqrt(fit.rms_before_mm / n);
  fit.rms_after_mm = std::sqrt(fit.rms_after_mm / n);
  return fit;
}

}  // namespace dorsum
