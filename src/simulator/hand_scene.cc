// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_scene.h"

#include <string>
#include <utility>

#include "base/random.h"
#include "simulator/hand_dressing.h"
#include "simulator/hand_mesh.h"

namespace dorsum {
namespace {

PosedHand DrawHand(const VirtualDevice& device, const SceneName& name, std::uint64_t person_seed) {
  Rng shape_rng(NamedSeed("shape", person_seed));
  HandShape shape = SampleHandShape(name.sex, shape_rng);
  const std::string visit = (name.side == Side::kLeft ? "left/k" : "right/k") + std::to_string(name.visit);
  if (name.visit > 0) {
    Rng visit_rng(NamedSeed("visit/k" + std::to_string(name.visit), person_seed));
    shape = VaryForSession(shape, visit_rng);
  }
  Rng pose_rng(NamedSeed("pose/" + visit, person_seed));
  HandPose pose = SampleHandPose(pose_rng);
  pose.centre += VisibleRectangle(device.camera, 20.0).center();
  return {shape, name.side, pose};
}

ScenePart SkinOf(const PosedHand& hand) {
  HandMesh built = BuildHand(hand.shape, hand.side, hand.pose);
  ScenePart part;
  part.paint.material = Material::kSkin;
  part.mesh = std::move(built.mesh);
  for (const Eigen::Vector3f& rgb : built.albedo)
    part.vertex_albedo.push_back(rgb.y());  // the light is green
  return part;
}

}  // namespace

void AddHand(const VirtualDevice& device, const SceneName& name, std::uint64_t people_seed, Scene& scene) {
  const std::uint64_t person_seed = NamedSeed("person/" + name.person, people_seed);
  const PosedHand hand = DrawHand(device, name, person_seed);
  ScenePart skin = SkinOf(hand);
  const SceneModifiers& modifiers = name.modifiers;
  if (Has(modifiers, Modifier::kDark)) Brighten(0.28, skin);
  if (Has(modifiers, Modifier::kLight)) Brighten(1.25, skin);
  if (Has(modifiers, Modifier::kNails)) VarnishNails(hand, skin);
  if (Has(modifiers, Modifier::kWet)) MakeWet(person_seed, skin);
  if (Has(modifiers, Modifier::kHair)) GrowHair(hand, person_seed, skin);
  scene.parts.push_back(std::move(skin));
  if (Has(modifiers, Modifier::kRing)) scene.parts.push_back(Ring(hand));
  if (Has(modifiers, Modifier::kSleeve)) scene.parts.push_back(Sleeve(hand));
}

}  // namespace dorsum
