// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "simulator/hand_pose.h"
#include "simulator/hand_shape.h"
#include "simulator/scene.h"
#include "simulator/scene_modifiers.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Scenes that can be asked for by name:
//   plane                       the empty backplane
//   plane_tilted                a tilted white plate
//   boxH                        a brown box of height H mm: box13.5
//   cylinderR, sphereR          a lying cylinder, a half-sunk sphere of radius R mm, grey
//   hand:SEX:SIDE:PERSON[:kN]   man or woman, left or right, any name of letters, digits, - and _;
//                               kN: the person's N-th visit (default 0), with another pose
//   whiteboxH                   a white box on the white backplane (§5.1)
// each with modifiers (scene_modifiers.h) behind plus signs, and an optional _rN at the very end: the same
// scene with other noise. A modifier changes neither the object's place nor the person.
struct SceneName {
  enum class Kind { kPlane, kTiltedPlane, kBox, kWhiteBox, kCylinder, kSphere, kHand };
  Kind kind = Kind::kPlane;
  double size_mm = 0.0;  // height or radius
  Sex sex = Sex::kMan;
  Side side = Side::kRight;
  std::string person;
  int visit = 0;
  std::string geometry;  // the name without modifiers and _rN: what the scene's shape is drawn from
  SceneModifiers modifiers;
  std::string folder;  // the name as a folder: hand_man_right_anna_k1
};

Result<SceneName> ParseSceneName(const std::string& text);

// The scene before a device, placed where the device sees it. Sizes and places are drawn from `seed` and the
// name; hands from `people_seed`, so that the same people can come to several devices.
Scene BuildNamedScene(const VirtualDevice& device, const SceneName& name, std::uint64_t seed,
                      std::uint64_t people_seed);

}  // namespace dorsum
