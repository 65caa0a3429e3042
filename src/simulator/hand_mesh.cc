// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "simulator/hand_skeleton.h"
#include "simulator/hand_skin.h"
#include "simulator/surface_nets.h"

namespace dorsum {

HandMesh BuildHand(const HandShape& shape, Side side, const HandPose& pose, double resolution_mm) {
  if (std::isnan(resolution_mm) || resolution_mm < 0.3 || resolution_mm > 4.0) {
    throw std::logic_error("a hand's resolution lies between 0.3 and 4 mm");
  }
  const HandSkin skin(shape, pose);
  SurfaceNetsOptions options;
  options.cell = resolution_mm;
  skin.Bounds(options.lo, options.hi);
  HandMesh hand;
  hand.mesh = SurfaceNets([&skin](const Eigen::Vector3d& point) { return skin.Distance(point); }, options);
  hand.albedo.reserve(hand.mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : hand.mesh.vertices) hand.albedo.push_back(skin.Albedo(vertex));

  const Eigen::Affine3d world_from_hand = WorldFromHand(side, pose);
  for (Eigen::Vector3d& vertex : hand.mesh.vertices) {
    vertex = world_from_hand * vertex;
    vertex.z() = std::max(vertex.z(), 0.0);
  }
  for (Eigen::Vector3d& normal : hand.mesh.normals) normal = world_from_hand.linear() * normal;
  if (side == Side::kLeft) {
    for (auto& face : hand.mesh.faces) std::swap(face[1], face[2]);
  }
  return hand;
}

}  // namespace dorsum
