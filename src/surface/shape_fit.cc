// SPDX-License-Identifier: Apache-2.0
#include "surface/shape_fit.h"

#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace dorsum {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d Mean(const Points& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points) mean += p;
  return mean / static_cast<double>(points.size());
}

// Principal axes of the points, by growing extent.
Eigen::Matrix3d PrincipalAxes(const Points& points, const Eigen::Vector3d& mean) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& p : points) covariance += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
}

// Algebraic sphere: |p|^2 = 2 c.p + (r^2 - |c|^2), with p relative to the mean. In `dimensions` 2 the third
// coordinate is left out, which gives a circle.
void AlgebraicSphere(const Points& relative, int dimensions, Eigen::Vector3d* center, double* radius) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const auto& p : relative) {
    Eigen::Vector4d row(p.x(), p.y(), dimensions == 3 ? p.z() : 0.0, 1.0);
    normal += row * row.transpose();
    right += row * row.head<3>().squaredNorm();
  }
  if (dimensions == 2) normal(2, 2) = 1.0;
  const Eigen::Vector4d s = normal.ldlt().solve(right);
  *center = 0.5 * s.head<3>();
  *radius = std::sqrt(std::max(1e-12, s[3] + center->squaredNorm()));
}

// Both axes perpendicular to the cylinder's, for its parameters.
Eigen::Matrix3d FrameAround(const Eigen::Vector3d& axis) {
  Eigen::Matrix3d frame;
  frame.col(0) = axis.unitOrthogonal();
  frame.col(1) = axis.cross(frame.col(0));
  frame.col(2) = axis;
  return frame;
}

// The shape after a small change of its parameters (centre in three or two directions, axis in two, radius).
ShapeFit Changed(const ShapeFit& fit, const Eigen::VectorXd& d) {
  ShapeFit out = fit;
  if (fit.shape == Shape::kSphere) {
    out.center += d.head<3>();
    out.radius_mm += d[3];
  } else {
    const Eigen::Matrix3d frame = FrameAround(fit.axis);
    out.center += frame.leftCols<2>() * d.head<2>();
    out.axis = (fit.axis + frame.leftCols<2>() * d.segment<2>(2)).normalized();
    out.radius_mm += d[4];
  }
  return out;
}

// A fit after its refinement, and how well the points tell its parameters apart.
struct Refined {
  ShapeFit fit;
  double squares = 0.0;     // sum over the points
  double determined = 0.0;  // least eigenvalue of the normal matrix of a point; 0: some change costs nothing
};

Refined Refine(ShapeFit fit, const Points& points) {
  const int n = fit.shape == Shape::kSphere ? 4 : 5;
  constexpr double kStep = 1e-6;
  Refined out;
  for (int iteration = 0; iteration < 50; ++iteration) {
    std::vector<ShapeFit> beside;
    beside.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) beside.push_back(Changed(fit, kStep * Eigen::VectorXd::Unit(n, k)));
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    out.squares = 0.0;
    for (const auto& p : points) {
      const double distance = fit.Distance(p);
      Eigen::VectorXd row(n);
      for (int k = 0; k < n; ++k)
        row[k] = (beside[static_cast<std::size_t>(k)].Distance(p) - distance) / kStep;
      normal += row * row.transpose();
      right -= row * distance;
      out.squares += distance * distance;
    }
    out.fit = fit;
    out.determined = normal.allFinite()
                         ? Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(normal).eigenvalues()[0] /
                               static_cast<double>(points.size())
                         : 0.0;
    const Eigen::VectorXd change = normal.ldlt().solve(right);
    if (!change.allFinite()) break;
    fit = Changed(fit, change);
    if (change.norm() < 1e-9) break;
  }
  out.fit.radius_mm = std::abs(out.fit.radius_mm);
  return out;
}

// Starts from the sphere, or from the cylinder whose axis is the last column of `frame`, that fits
// algebraically.
Refined FitFrom(Shape shape, const Eigen::Matrix3d& frame, const Points& points,
                const Eigen::Vector3d& mean) {
  Points relative;
  for (const auto& p : points) relative.emplace_back(frame.transpose() * (p - mean));
  ShapeFit start;
  start.shape = shape;
  Eigen::Vector3d center;
  AlgebraicSphere(relative, shape == Shape::kCylinder ? 2 : 3, &center, &start.radius_mm);
  start.center = mean + frame * center;
  if (shape == Shape::kCylinder) start.axis = frame.col(2);
  return Refine(start, points);
}

}  // namespace

double ShapeFit::Distance(const Eigen::Vector3d& p) const {
  switch (shape) {
    case Shape::kPlane:
      return axis.dot(p - center);
    case Shape::kSphere:
      return (p - center).norm() - radius_mm;
    case Shape::kCylinder:
      return (p - center).cross(axis).norm() - radius_mm;
  }
  return 0.0;
}

Result<ShapeFit> FitShape(Shape shape, const Points& points) {
  if (points.size() < 10) return BadInput("too few points to fit a shape to");
  const Eigen::Vector3d mean = Mean(points);
  const Eigen::Matrix3d axes = PrincipalAxes(points, mean);
  ShapeFit fit;
  fit.shape = shape;
  if (shape == Shape::kPlane) {
    fit.center = mean;
    fit.axis = axes.col(0).z() < 0.0 ? Eigen::Vector3d(-axes.col(0)) : Eigen::Vector3d(axes.col(0));
    return fit;
  }
  // Points of a cylinder may reach further along its axis or around it: each principal axis is tried.
  std::vector<Eigen::Matrix3d> frames = {Eigen::Matrix3d::Identity()};
  if (shape == Shape::kCylinder) {
    frames[0] << axes.col(0), axes.col(1), axes.col(2);
    for (int turn = 1; turn < 3; ++turn) {
      const Eigen::Matrix3d& last = frames.back();
      Eigen::Matrix3d next;
      next << last.col(2), last.col(0), last.col(1);
      frames.push_back(next);
    }
  }
  std::optional<Refined> best;
  for (const Eigen::Matrix3d& frame : frames) {
    const Refined one = FitFrom(shape, frame, points, mean);
    // Small caps leave about 1e-6; points on a line, on a plane or all in one place nothing but rounding.
    const bool usable = one.fit.center.allFinite() && one.fit.radius_mm < 1e5 && one.determined > 1e-8;
    if (usable && (!best || one.squares < best->squares)) best = one;
  }
  // Spheres and cylinders come as close to a plane as one likes: who fits worse than it has lost its way.
  double squares_of_plane = 0.0;
  for (const auto& p : points) squares_of_plane += std::pow(axes.col(0).dot(p - mean), 2);
  if (!best || best->squares > squares_of_plane)
    return BadInput("the points do not determine the shape; are they flat?");
  fit = best->fit;
  return fit;
}

}  // namespace dorsum
