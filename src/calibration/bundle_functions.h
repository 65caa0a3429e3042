// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>
#include <ceres/jet.h>
#include <ceres/rotation.h>

#include "calibration/bundle_model.h"

// The bundle's model over its parameters, for numbers and for numbers with derivatives (ceres::Jet). For
// sources only: no header shows Ceres.
namespace dorsum::bundle {

template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

inline double Value(double x) { return x; }
template <class T, int N>
double Value(const ceres::Jet<T, N>& x) {
  return x.a;
}

// Rotation start * exp(turn) of a vector: a_from_b with its turn in b.
template <class T>
Vector3<T> Transform(const Eigen::Matrix3d& start, const T* pose, const Vector3<T>& p) {
  Vector3<T> turned;
  ceres::AngleAxisRotatePoint(pose, p.data(), turned.data());
  const Vector3<T> rotated = start.cast<T>() * turned;
  return {rotated[0] + pose[3], rotated[1] + pose[4], rotated[2] + pose[5]};
}

template <class T, class S>
Vector2<T> DistortNormalized(const S* lens, const T& x, const T& y) {
  const T r2 = x * x + y * y;
  const T radial = 1.0 + r2 * (lens[4] + r2 * (lens[5] + r2 * lens[8]));
  return {x * radial + 2.0 * lens[6] * x * y + lens[7] * (r2 + 2.0 * x * x),
          y * radial + lens[6] * (r2 + 2.0 * y * y) + 2.0 * lens[7] * x * y};
}

template <class T>
Vector2<T> ProjectPoint(const T* lens, const Vector3<T>& in_camera) {
  const Vector2<T> d =
      DistortNormalized<T, T>(lens, in_camera[0] / in_camera[2], in_camera[1] / in_camera[2]);
  return {lens[0] * d[0] + lens[2], lens[1] * d[1] + lens[3]};
}

// The inverse of the distortion, and by the implicit function theorem its derivatives: one Newton step from
// the solution changes nothing but carries them.
template <class T>
Vector2<T> UndistortPixel(const T* lens, const Eigen::Vector2d& pixel) {
  Camera plain;
  plain.fx = plain.fy = 1.0;
  for (std::size_t i = 0; i < 5; ++i) plain.distortion[i] = Value(lens[4 + i]);
  const Vector2<T> distorted((pixel.x() - lens[2]) / lens[0], (pixel.y() - lens[3]) / lens[1]);
  const Eigen::Vector2d n = Undistort(plain, {Value(distorted[0]), Value(distorted[1])});
  std::array<double, kLensSize> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = Value(lens[i]);
  using Jet2 = ceres::Jet<double, 2>;
  const Vector2<Jet2> there = DistortNormalized<Jet2, double>(values.data(), Jet2(n.x(), 0), Jet2(n.y(), 1));
  Eigen::Matrix2d jacobian;
  jacobian << there[0].v[0], there[0].v[1], there[1].v[0], there[1].v[1];
  const Vector2<T> miss = DistortNormalized<T, T>(lens, T(n.x()), T(n.y())) - distorted;
  const Eigen::Matrix2d inverse = jacobian.inverse();
  return {n.x() - (inverse(0, 0) * miss[0] + inverse(0, 1) * miss[1]),
          n.y() - (inverse(1, 0) * miss[0] + inverse(1, 1) * miss[1])};
}

// The world point of a plane of known height that is seen at a place of the undistorted picture, whose focal
// length is 1.
template <class T>
Vector3<T> PointOnPlane(const Vector2<T>& n, const Eigen::Matrix3d& camera_start, const T* camera_from_world,
                        const T* plane) {
  const Vector3<T> in_camera(n[0], n[1], T(1.0));
  const Vector3<T> translation(camera_from_world[3], camera_from_world[4], camera_from_world[5]);
  const T back[3] = {-camera_from_world[0], -camera_from_world[1], -camera_from_world[2]};
  const Eigen::Matrix<T, 3, 3> start = camera_start.transpose().cast<T>();
  const Vector3<T> half_direction = start * in_camera, half_centre = start * translation;
  Vector3<T> direction, centre;
  ceres::AngleAxisRotatePoint(back, half_direction.data(), direction.data());
  ceres::AngleAxisRotatePoint(back, half_centre.data(), centre.data());
  centre = -centre;
  // z = h + sx x + sy y
  const T t = (plane[0] + plane[1] * centre[0] + plane[2] * centre[1] - centre[2]) /
              (direction[2] - plane[1] * direction[0] - plane[2] * direction[1]);
  return centre + t * direction;
}

// The same for a pixel.
template <class T>
Vector3<T> PointOnPlane(const T* lens, const Eigen::Matrix3d& camera_start, const T* camera_from_world,
                        const T* plane, const Eigen::Vector2d& pixel) {
  return PointOnPlane<T>(UndistortPixel(lens, pixel), camera_start, camera_from_world, plane);
}

// DiffractedFan's Locate() and Order() with derivatives, by the same device as UndistortPixel.
template <class T>
T OrderAt(const Eigen::Matrix3d& axes, const T* fan, const Vector3<T>& world) {
  const Vector3<T> d(world[0] - fan[0], world[1] - fan[1], world[2] - fan[2]);
  const T back[3] = {-fan[kFanTurn], -fan[kFanTurn + 1], -fan[kFanTurn + 2]};
  Vector3<T> turned;
  ceres::AngleAxisRotatePoint(back, d.data(), turned.data());
  const Vector3<T> local = axes.transpose().cast<T>() * turned;
  const T &s = fan[kFanDistance], &skew = fan[kFanSkew], &bow = fan[kFanBow];
  const auto alpha_in = [&](const auto& beta, const auto& a0, const auto& a1, const auto& a2) {
    using std::sqrt;
    return a0 + a1 * beta + a2 * (sqrt(1.0 - beta * beta) - 1.0);
  };
  // One step of beta = (y - y_g(beta)) / distance; also gives the distance along x.
  const auto step = [&](const auto& beta, const auto& x, const auto& y, const auto& z, const auto& distance,
                        const auto& a0, const auto& a1, const auto& a2, auto* dx, auto* length) {
    using std::sqrt;
    const auto alpha = alpha_in(beta, a0, a1, a2);
    const auto y_g = distance * beta / sqrt(1.0 - alpha * alpha - beta * beta);
    *dx = x - a1 * y_g;
    const auto dy = y - y_g;
    *length = sqrt(*dx * *dx + dy * dy + z * z);
    return dy / *length;
  };
  const double x = Value(local[0]), y = Value(local[1]), z = Value(local[2]), s0 = Value(s),
               a0 = Value(fan[kFanAlpha]), a1 = Value(skew), a2 = Value(bow);
  double beta = y / std::sqrt(x * x + y * y + z * z), dx = 0.0, length = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double next = step(beta, x, y, z, s0, a0, a1, a2, &dx, &length);
    const double change = std::abs(next - beta);
    beta = next;
    if (change < 1e-15) break;
  }
  using Jet1 = ceres::Jet<double, 1>;
  Jet1 jet_dx, jet_length;
  const Jet1 slope = step(Jet1(beta, 0), Jet1(x), Jet1(y), Jet1(z), Jet1(s0), Jet1(a0), Jet1(a1), Jet1(a2),
                          &jet_dx, &jet_length);
  T dx_t, length_t;
  const T next = step(T(beta), local[0], local[1], local[2], s, fan[kFanAlpha], skew, bow, &dx_t, &length_t);
  const T exact = beta + (next - beta) / (1.0 - slope.v[0]);
  // Once more with the exact beta, for the distances' own derivatives.
  (void)step(exact, local[0], local[1], local[2], s, fan[kFanAlpha], skew, bow, &dx_t, &length_t);
  return (dx_t / length_t - alpha_in(exact, fan[kFanAlpha], skew, bow)) / fan[kFanStep];
}

}  // namespace dorsum::bundle
