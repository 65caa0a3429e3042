// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/camera.h"
#include "geometry/mesh.h"
#include "geometry/rigid3.h"

namespace dorsum {

// What a pixel shows; the numbers are those of material.png.
enum class Material : std::uint8_t {
  kBackplane = 0,
  kBoardWhite = 1,
  kBoardBlack = 2,
  kBrown = 3,
  kSkin = 4,
  kGrey = 5,
};

struct Paint {
  Material material = Material::kBackplane;
  double albedo = 0.82;  // share of green light that is reflected, in all directions alike
  double gloss = 0.0;  // share that is mirrored when light falls straight on, besides: water 0.02, metal 0.6
};

// Paint at a world point, averaged over a square of side `footprint_mm`, which is what one pixel sees: so
// printed edges come out without steps.
using Pattern = std::function<Paint(const Eigen::Vector3d& world, double footprint_mm)>;
// What thin dark lines leave of the albedo at a point, averaged in the same way.
using Strands = std::function<double(const Eigen::Vector3d& world, double footprint_mm)>;

struct ScenePart {
  TriangleMesh mesh;  // vertex normals make it look smooth; none: flat faces
  Paint paint;
  double mottle = 0.0;               // amplitude of soft spots in the albedo, as a share of it
  std::vector<float> vertex_albedo;  // one per vertex instead of paint.albedo, or empty
  std::vector<float> vertex_gloss;   // the same instead of paint.gloss
  double shininess = 300.0;          // of the gloss: exponent of the highlight's cosine, 1 to 5000
  Pattern pattern;                   // instead of all these, or empty
  Strands strands;                   // hair on top, or empty
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();  // mm: patterns, spots and strands went along
  bool is_object = true;                            // stands on the backplane: goes into reference.ply
};

struct Scene {
  std::vector<ScenePart> parts;
};

// Takes all objects elsewhere, with what is on them.
void MoveObjects(const Eigen::Vector3d& by_mm, Scene& scene);

// The plane z = 0 of white paper, wider than any picture.
ScenePart Backplane();

// A box whose top lies at `height_mm` and whose walls stand on the backplane.
struct BoxPlace {
  Eigen::Vector2d centre_mm = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_mm{80.0, 60.0};
  double height_mm = 25.0;
  double yaw = 0.0;  // rad
};
ScenePart BrownBox(const BoxPlace& place);
ScenePart WhiteBox(const BoxPlace& place);  // the calibration object

// A thin white plate; its upper face is the plane z = 0 of the plate's frame, around the origin.
ScenePart WhitePlate(const Rigid3& world_from_plate, const Eigen::Vector2d& size_mm,
                     double thickness_mm = 2.0);

// A cylinder that lies on the backplane, and the upper half of a sphere around a point of it; both grey, both
// within 0.001 mm of the true surface.
ScenePart LyingCylinder(double radius_mm, double length_mm, const Eigen::Vector2d& centre_mm, double yaw);
ScenePart HalfSphere(double radius_mm, const Eigen::Vector2d& centre_mm);

// All object parts as one mesh.
TriangleMesh ObjectMesh(const Scene& scene);

// Largest rectangle along x and y, at height z, that lies inside the picture with `margin` (share of its
// size).
Eigen::AlignedBox2d VisibleRectangle(const Camera& camera, double z, double margin = 0.0);

}  // namespace dorsum
