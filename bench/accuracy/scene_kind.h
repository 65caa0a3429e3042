// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace dorsum::accuracy {

enum class SceneKind { kBox, kHand, kSphere, kCylinder, kOther };
const char* KindName(SceneKind kind);  // "box", "hand" ...

// What a capture's folder name says about it: box25.5_r1, sphere25, hand_man_left_p3_k1, id02_R_k0.
struct SceneInfo {
  SceneKind kind = SceneKind::kOther;
  double size_mm = 0.0;  // a box's height, a radius
  std::string scene;     // without the repeat's _rN
};
SceneInfo DescribeScene(const std::string& folder_name);

}  // namespace dorsum::accuracy
