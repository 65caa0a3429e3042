// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace dorsum {

// One section of a swept body; lengths in mm. Between sections everything runs smoothly.
struct SweptSection {
  double s = 0;             // along the sweep's direction, from its origin; increasing
  double offset = 0;        // of the section's centre, to the left of the direction
  double z = 0;             // of the section's centre
  double half_breadth = 0;  // square to the curve through the centres
  double dorsal = 0;        // depth above the centre
  double palmar = 0;        // depth below it
};

struct SweptBodyOptions {
  double near_cap = 8.0;  // how far the rounded ends reach before the first and beyond the last section
  double far_cap = 8.0;
  double exponent = 2.0;   // of the superelliptic sections: 2 is an ellipse, more is squarer; [2, 4]
  double roll = 0.0;       // rad: turn of the sections about the curve, dorsal side towards the left
  double smoothing = 2.0;  // mm: standard deviation of the Gaussian that rounds the profile
};

// A soft body whose sections, of differing half-ellipses above and below, are strung along a nearly straight
// curve over a horizontal line: a finger, a metacarpal with its flesh, a forearm. Sections stand square to
// the line, so that finding a point's section is one projection; slopes up to about 20 deg are compensated.
class SweptBody {
 public:
  // A point in the body's own terms.
  struct Place {
    double s, u, v;                   // along, across (left), above the section's centre, mm
    double half_breadth, half_depth;  // of the section; the depth on the point's side
    double cap;                       // 0 within the sections, 1 at the very end of a rounded end
    double outside;                   // distance to the box around the body; beyond kFar nothing else is set
  };
  static constexpr double kFar = 30.0;

  SweptBody() = default;
  SweptBody(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
            const std::vector<SweptSection>& sections, const SweptBodyOptions& options = {});

  Place Locate(const Eigen::Vector3d& point) const;
  // Signed distance to first order: exact in zero set and, there, in slope; a lower bound farther than kFar
  // away.
  double DistanceAt(const Place& place) const;
  double Distance(const Eigen::Vector3d& point) const { return DistanceAt(Locate(point)); }

  // The horizontal box around the body, grown by `margin`, in the frame that `point` lives in.
  void GrowBounds(Eigen::Vector3d& lo, Eigen::Vector3d& hi, double margin) const;

 private:
  using Row = std::array<double, 5>;  // offset, z, half_breadth, dorsal, palmar
  Row ProfileAt(double s) const;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero(), along_ = Eigen::Vector2d::UnitX(), left_;
  SweptBodyOptions options_;
  double first_ = 0, last_ = 0;  // the outermost sections
  double cos_roll_ = 1, sin_roll_ = 0;
  std::vector<Row> table_;           // B-spline coefficients, kStep apart from first_ - near_cap
  Eigen::Vector3d box_lo_, box_hi_;  // in (s, left, z)
};

}  // namespace dorsum
