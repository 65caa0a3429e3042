// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/light_sheet.h"
#include "geometry/ray.h"

namespace dorsum {

// Which of the two models of a light sheet is meant (DESIGN §3).
enum class SheetModel { kPlane, kCone };

// The document's sheet of one order: a plane through the grating point and a line on the backplane (§3.6).
struct PlaneSheet {
  int order = 0;
  Plane plane;  // world, mm; the normal points towards growing order
};

// Second-order surface error correction e(x, z) of equation 3.7, x and z in mm:
// c1 + c2 x + c3 z + c4 x^2 + c5 x z + c6 z^2. Zero means no correction.
struct CorrectionPolynomial {
  std::array<double, 6> c{};
  double Evaluate(double x, double z) const {
    return c[0] + c[1] * x + c[2] * z + c[3] * x * x + c[4] * x * z + c[5] * z * z;
  }
  // Equation 3.9.
  double CorrectedZ(double x, double z) const { return z * (1.0 - Evaluate(x, z)); }
};

// How a stripe looks on the empty backplane (reference images, §3.2): column and brightness as polynomials of
// t = (row - middle) / half, which runs from -1 to 1 over the rows in which it was seen.
struct ReferenceStripe {
  int order = 0;
  double middle_v = 0.0, half_v = 1.0;  // px
  std::array<double, 4> u{};            // px: u0 + u1 t + u2 t^2 + u3 t^3
  std::array<double, 3> peak{};         // green value: p0 + p1 t + p2 t^2

  bool Covers(double v) const { return v >= middle_v - half_v && v <= middle_v + half_v; }
  double ColumnAt(double v) const;
  double PeakAt(double v) const;
};

// One calibrated laser. Sheets of both models may be there, or only one of them.
struct LaserGeometry {
  int laser = 0;
  Eigen::Vector3d grating = Eigen::Vector3d::Zero();  // the document's point G (§3.2), world, mm
  std::vector<PlaneSheet> planes;                     // by growing order, without gaps; empty: no plane model
  std::optional<DiffractedFan> fan;                   // cone model
  int min_order = 0, max_order = 0;                   // orders seen on the backplane
  std::vector<ReferenceStripe> reference;             // by growing order
  CorrectionPolynomial correction;                    // belongs to the plane model
  double residual_mm = 0.0;  // what calibration leaves of the height error, one standard deviation

  const PlaneSheet* FindPlane(int order) const;
};

// All that a reconstruction needs to know of a device, in the world frame of DESIGN §2.
struct DeviceGeometry {
  Camera camera;
  std::vector<LaserGeometry> lasers;                 // ascending by laser
  double min_height_mm = 0.0, max_height_mm = 80.0;  // working volume

  const LaserGeometry* FindLaser(int laser) const;
};

// The order, as a real number, whose sheet passes through the point that a pixel sees at height z; none where
// the pixel's ray does not reach that height or the laser has no such model. At a stripe of order m on a
// surface of that height the value is m. Beyond the calibrated planes the spacing of the last two goes on.
std::optional<double> OrderAtHeight(const Camera& camera, const LaserGeometry& laser, SheetModel model,
                                    const Eigen::Vector2d& pixel, double z_mm);
std::optional<double> OrderAtHeight(const Ray& ray, const LaserGeometry& laser, SheetModel model,
                                    double z_mm);

// Where a ray meets the sheet of an order; none where it does not, or the order has no sheet. Cones are met
// by iteration from the height `start_mm`.
std::optional<Eigen::Vector3d> IntersectSheet(const Ray& ray, const LaserGeometry& laser, SheetModel model,
                                              int order, double start_mm = 0.0);

}  // namespace dorsum
