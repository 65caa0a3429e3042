// SPDX-License-Identifier: Apache-2.0
#include "accuracy/scene_kind.h"

#include <charconv>
#include <regex>

namespace dorsum::accuracy {

const char* KindName(SceneKind kind) {
  switch (kind) {
    case SceneKind::kBox:
      return "box";
    case SceneKind::kHand:
      return "hand";
    case SceneKind::kSphere:
      return "sphere";
    case SceneKind::kCylinder:
      return "cylinder";
    case SceneKind::kOther:
      break;
  }
  return "other";
}

SceneInfo DescribeScene(const std::string& folder_name) {
  SceneInfo info;
  info.scene = std::regex_replace(folder_name, std::regex("_r[0-9]+$"), "");
  if (info.scene.starts_with("hand_") || std::regex_match(info.scene, std::regex("id[0-9]+_.*"))) {
    info.kind = SceneKind::kHand;
    return info;
  }
  std::smatch match;
  if (!std::regex_match(info.scene, match, std::regex("(box|sphere|cylinder)([0-9]+(\\.[0-9]+)?)")))
    return info;
  const std::string form = match[1], size = match[2];
  info.kind = form == "box" ? SceneKind::kBox : form == "sphere" ? SceneKind::kSphere : SceneKind::kCylinder;
  std::from_chars(size.data(), size.data() + size.size(), info.size_mm);
  return info;
}

}  // namespace dorsum::accuracy
