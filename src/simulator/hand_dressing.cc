// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_dressing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "simulator/hand_skeleton.h"
#include "simulator/hand_skin.h"
#include "simulator/skin_noise.h"
#include "simulator/smooth_blend.h"
#include "simulator/surface_nets.h"

namespace dorsum {
namespace {

constexpr float kBrightest = 0.85F;

// A shape of the hand's frame as a part of the world, cut off at the backplane.
ScenePart PartOf(const PosedHand& hand, const SignedDistance& distance, const SurfaceNetsOptions& options) {
  ScenePart part;
  part.mesh = SurfaceNets(distance, options);
  const Eigen::Affine3d world_from_hand = WorldFromHand(hand.side, hand.pose);
  for (Eigen::Vector3d& vertex : part.mesh.vertices) {
    vertex = world_from_hand * vertex;
    vertex.z() = std::max(vertex.z(), 0.0);
  }
  for (Eigen::Vector3d& normal : part.mesh.normals) normal = world_from_hand.linear() * normal;
  if (hand.side == Side::kLeft) {
    for (auto& face : part.mesh.faces) std::swap(face[1], face[2]);
  }
  return part;
}

}  // namespace

ScenePart Ring(const PosedHand& hand) {
  constexpr double kHalfWidth = 2.5, kThickness = 1.1, kBeyondWeb = 5.0, kRounding = 0.4;  // mm
  const HandSkin skin(hand.shape, hand.pose);
  const HandSkeleton& bones = skin.Skeleton();
  const FingerBones& finger = bones.fingers[2];
  const Eigen::Vector3d axis = (finger.pip - finger.mcp).normalized();
  const double web =
      std::max(axis.dot(bones.crotches[2] - finger.mcp), axis.dot(bones.crotches[3] - finger.mcp));
  const double at = std::min(web + kBeyondWeb, (finger.pip - finger.mcp).norm() - 2.0 * kHalfWidth);
  const Eigen::Vector3d centre = finger.mcp + at * axis;
  const double reach = 0.58 * hand.shape.fingers[2].pip_breadth + kThickness + 0.8;  // not to the next finger
  const auto band = [&](const Eigen::Vector3d& p) {
    const double along = axis.dot(p - centre);
    const double radius = (p - centre - along * axis).norm();
    const double inside =
        SmoothIntersection(skin.Distance(p) - kThickness, std::abs(along) - kHalfWidth, kRounding);
    return std::max({inside, radius - reach, -p.z()});
  };
  SurfaceNetsOptions options;
  options.cell = 0.4;
  options.lo = centre.array() - (reach + 3.0);
  options.hi = centre.array() + (reach + 3.0);
  options.lo.z() = -1.0;
  ScenePart part = PartOf(hand, band, options);
  part.paint = {Material::kGrey, 0.10, 0.6};
  part.shininess = 80.0;
  return part;
}

ScenePart Sleeve(const PosedHand& hand) {
  constexpr double kThickness = 3.0, kFold = 0.9, kFoldPitch = 11.0, kOverHand = 6.0;  // mm
  const HandSkin skin(hand.shape, hand.pose);
  const HandSkeleton& bones = skin.Skeleton();
  const Eigen::Vector3d forearm(bones.forearm.x(), bones.forearm.y(), 0.0);
  const SkinNoise waves(NamedSeed("sleeve", hand.shape.detail.seed), 25.0);
  const auto cloth = [&](const Eigen::Vector3d& p) {
    const double along = forearm.dot(p - bones.wrist);
    const double cuff = -kOverHand - along;
    if (cuff > 5.0) return cuff;
    const double phase = 2.0 * std::numbers::pi * along / kFoldPitch + 1.5 * waves.At(p);
    return std::max({skin.Distance(p) - kThickness - kFold * std::sin(phase), cuff, -p.z()});
  };
  SurfaceNetsOptions options;
  options.cell = 1.0;
  options.steepness = 2.5;
  skin.Bounds(options.lo, options.hi);
  options.lo.array() -= 6.0;
  options.lo.z() = -1.0;
  options.hi.array() += 6.0;
  options.hi.x() = std::min(options.hi.x(), bones.wrist.x() + 25.0);
  ScenePart part = PartOf(hand, cloth, options);
  part.paint = {Material::kGrey, 0.28};
  part.mottle = 0.1;
  return part;
}

void Brighten(double factor, ScenePart& skin) {
  for (float& albedo : skin.vertex_albedo) {
    albedo = std::min(kBrightest, albedo * static_cast<float>(factor));
  }
}

void MakeWet(std::uint64_t seed, ScenePart& skin) {
  constexpr double kGloss = 0.03, kPatchMm = 20.0;
  const SkinNoise patches(NamedSeed("wet", seed), kPatchMm);
  skin.vertex_gloss.resize(skin.mesh.vertices.size(), 0.0F);
  for (std::size_t i = 0; i < skin.mesh.vertices.size(); ++i) {
    const double wet = SmoothStep(-0.3, 0.1, patches.At(skin.mesh.vertices[i]));
    skin.vertex_gloss[i] = std::max(skin.vertex_gloss[i], static_cast<float>(kGloss * wet));
    skin.vertex_albedo.at(i) *= static_cast<float>(1.0 - 0.12 * wet);  // light is lost in the film
  }
}

void VarnishNails(const PosedHand& hand, ScenePart& skin) {
  constexpr double kGloss = 0.05, kVarnish = 0.62;
  const HandSkin shape(hand.shape, hand.pose);
  const Eigen::Affine3d hand_from_world = WorldFromHand(hand.side, hand.pose).inverse();
  skin.vertex_gloss.resize(skin.mesh.vertices.size(), 0.0F);
  for (std::size_t i = 0; i < skin.mesh.vertices.size(); ++i) {
    const double nail = shape.Nail(hand_from_world * skin.mesh.vertices[i]);
    float& albedo = skin.vertex_albedo.at(i);
    albedo += static_cast<float>(nail * (kVarnish - static_cast<double>(albedo)));
    skin.vertex_gloss[i] = std::max(skin.vertex_gloss[i], static_cast<float>(kGloss * nail));
  }
}

}  // namespace dorsum
