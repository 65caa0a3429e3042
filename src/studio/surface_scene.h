// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/ray.h"
#include "studio/surface_colours.h"
#include "studio/workbench.h"

namespace dorsum {

// A vertex as the graphics card takes it.
struct SceneVertex {
  std::array<float, 3> position{}, normal{};         // world, mm; unit
  std::array<std::uint8_t, 4> colour{0, 0, 0, 255};  // red first
};

// A stripe of one image: all points of one laser, order and segment. Points out of a file have no segment
// (0), so that there a stripe is all of one laser and order.
struct StripeKey {
  std::uint8_t laser = 0;
  std::int16_t order = 0;
  std::int32_t segment = 0;
  bool operator==(const StripeKey&) const = default;
};
inline StripeKey KeyOf(const SurfacePoint& p) { return {p.laser, p.order, p.segment}; }

// What a surface looks like, ready to be drawn: made once for each scan and choice of colours.
struct SceneBuffers {
  std::vector<SceneVertex> points;  // in an order in which any first n are spread over the whole surface
  std::vector<SceneVertex> vertices;
  std::vector<std::uint32_t> triangles;                                           // three of `vertices` each
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();  // bounding box, mm
  ColourScale scale;
  DifferenceSummary difference;  // of the mesh, or of the points where there is none
};
SceneBuffers MakeBuffers(const Reconstruction& surface, ColourBy by, const OtherHeight& other);

// What lies over the surface: lines as rows of small dots, chosen places as large ones.
struct SceneMarks {
  std::vector<Eigen::Vector3d> line, places;  // world, mm
};

// A place of the surface that a person points at.
struct Picked {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // world, mm
  std::optional<std::uint32_t> face;                   // of the mesh
  std::optional<std::uint32_t> point;                  // the surface point there, or within 2 mm of it
  std::optional<Eigen::Vector2d> image;                // px, where the camera sees it
};

enum class Shown { kMesh, kPoints, kBoth };

// The first place of the shown surface that the ray meets. A point is met when the ray passes by within
// `slope` of its distance. None where there is nothing.
std::optional<Picked> Pick(const Scan& scan, const Ray& ray, Shown shown, double slope);

// The surface point nearest to a place of an image of `laser` (any laser, if none), at most `reach_px` away.
std::optional<std::uint32_t> PickInImage(const SurfacePoints& points, const Eigen::Vector2d& pixel,
                                         std::optional<int> laser, double reach_px);

// All points of a stripe, from the image's top down.
std::vector<std::uint32_t> PointsOfStripe(const SurfacePoints& points, const StripeKey& key);

}  // namespace dorsum
