// SPDX-License-Identifier: Apache-2.0
#include "simulator/named_scene.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "simulator/hand_dressing.h"
#include "simulator/hand_mesh.h"

namespace dorsum {
namespace {

constexpr const char* kForms =
    "plane, plane_tilted, boxH and whiteboxH (height 1 to 150 mm), cylinderR and sphereR (radius 2 to 60 "
    "mm), "
    "hand:man|woman:left|right:PERSON[:kN], each with modifiers (+ring …) and an optional _rN";

std::optional<double> Number(std::string_view text, double min, double max) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= min && value <= max)) return {};
  return value;
}

std::optional<int> WholeNumber(std::string_view text) {
  const bool digits = !text.empty() && text.size() <= 6 &&
                      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? std::optional<int>(std::stoi(std::string(text))) : std::nullopt;
}

// Takes away a repeat's "_r2".
std::string WithoutRepeat(const std::string& name) {
  const std::size_t at = name.rfind("_r");
  const bool repeat = at != std::string::npos && at > 0 && WholeNumber(std::string_view(name).substr(at + 2));
  return repeat ? name.substr(0, at) : name;
}

bool ParseSized(SceneName& name, std::string_view prefix, SceneName::Kind kind, double min, double max) {
  if (!name.geometry.starts_with(prefix)) return false;
  const auto size = Number(std::string_view(name.geometry).substr(prefix.size()), min, max);
  if (size) {
    name.kind = kind;
    name.size_mm = *size;
  }
  return size.has_value();
}

bool ParseHand(SceneName& name) {
  std::vector<std::string> fields;
  std::string_view rest = name.geometry;
  for (std::size_t at = rest.find(':'); at != std::string_view::npos; at = rest.find(':')) {
    fields.emplace_back(rest.substr(0, at));
    rest.remove_prefix(at + 1);
  }
  fields.emplace_back(rest);
  if ((fields.size() != 4 && fields.size() != 5) || fields[0] != "hand") return false;
  if (fields[1] != "man" && fields[1] != "woman") return false;
  if (fields[2] != "left" && fields[2] != "right") return false;
  const bool plain =
      !fields[3].empty() && std::all_of(fields[3].begin(), fields[3].end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_';
      });
  if (!plain) return false;
  if (fields.size() == 5) {
    const auto visit =
        fields[4].starts_with('k') ? WholeNumber(std::string_view(fields[4]).substr(1)) : std::nullopt;
    if (!visit) return false;
    name.visit = *visit;
  }
  name.kind = SceneName::Kind::kHand;
  name.sex = fields[1] == "man" ? Sex::kMan : Sex::kWoman;
  name.side = fields[2] == "left" ? Side::kLeft : Side::kRight;
  name.person = fields[3];
  return true;
}

// Where single objects lie: near the middle of what is seen at half their height, turned a little.
struct Spot {
  Eigen::Vector2d centre, size;  // size: of the visible rectangle
  double yaw = 0.0;
};

Spot DrawSpot(const VirtualDevice& device, double z, Rng& rng) {
  const Eigen::AlignedBox2d seen = VisibleRectangle(device.camera, z);
  Spot spot{seen.center(), seen.sizes()};
  const double dx = rng.Uniform(-0.06, 0.06), dy = rng.Uniform(-0.06, 0.06);
  spot.centre += Eigen::Vector2d(dx * spot.size.x(), dy * spot.size.y());
  spot.yaw = rng.Uniform(-12.0, 12.0) * std::numbers::pi / 180.0;
  return spot;
}

BoxPlace DrawBox(const VirtualDevice& device, double height, Rng& rng) {
  const Spot spot = DrawSpot(device, 0.5 * height, rng);
  BoxPlace place;
  place.centre_mm = spot.centre;
  const double share_x = rng.Uniform(0.26, 0.34), share_y = rng.Uniform(0.32, 0.42);
  place.size_mm = {share_x * spot.size.x(), share_y * spot.size.y()};
  place.height_mm = height;
  place.yaw = spot.yaw;
  return place;
}

ScenePart DrawTiltedPlate(const VirtualDevice& device, Rng& rng) {
  const Spot spot = DrawSpot(device, 20.0, rng);
  const Eigen::Vector2d size(0.32 * spot.size.x(), 0.4 * spot.size.y());
  const double azimuth = rng.Uniform(0.0, 2.0 * std::numbers::pi);
  const double tilt = rng.Uniform(14.0, 20.0) * std::numbers::pi / 180.0;
  const Eigen::Vector3d axis(std::cos(azimuth), std::sin(azimuth), 0.0);
  Rigid3 world_from_plate;
  world_from_plate.rotation =
      (Eigen::AngleAxisd(tilt, axis) * Eigen::AngleAxisd(spot.yaw, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  world_from_plate.translation << spot.centre, 0.0;
  constexpr double kThickness = 2.0, kGap = 1.0;
  ScenePart plate = WhitePlate(world_from_plate, size, kThickness);
  double lowest = 0.0;
  for (const Eigen::Vector3d& v : plate.mesh.vertices) lowest = std::min(lowest, v.z());
  for (Eigen::Vector3d& v : plate.mesh.vertices) v.z() += kGap - lowest;
  return plate;
}

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

}  // namespace

Result<SceneName> ParseSceneName(const std::string& text) {
  using Kind = SceneName::Kind;
  SceneName name;
  name.geometry = WithoutRepeat(text);
  name.folder = text;
  std::replace(name.folder.begin(), name.folder.end(), ':', '_');
  if (const std::size_t plus = name.geometry.find('+'); plus != std::string::npos) {
    const std::string words = name.geometry.substr(plus + 1);
    name.geometry.resize(plus);
    DORSUM_ASSIGN_OR_RETURN(name.modifiers, ParseModifiers(words, name.geometry.starts_with("hand:")));
  }
  if (name.geometry == "plane") return name;
  if (name.geometry == "plane_tilted") {
    name.kind = Kind::kTiltedPlane;
    return name;
  }
  if (ParseSized(name, "box", Kind::kBox, 1.0, 150.0) ||
      ParseSized(name, "whitebox", Kind::kWhiteBox, 1.0, 150.0) ||
      ParseSized(name, "cylinder", Kind::kCylinder, 2.0, 60.0) ||
      ParseSized(name, "sphere", Kind::kSphere, 2.0, 60.0) || ParseHand(name)) {
    return name;
  }
  return UsageError("there is no scene \"" + text + "\"; known are " + kForms);
}

Scene BuildNamedScene(const VirtualDevice& device, const SceneName& name, std::uint64_t seed,
                      std::uint64_t people_seed) {
  using Kind = SceneName::Kind;
  Rng rng(NamedSeed("scene/" + name.geometry, seed));
  Scene scene;
  scene.parts.push_back(Backplane());
  switch (name.kind) {
    case Kind::kPlane:
      break;
    case Kind::kTiltedPlane:
      scene.parts.push_back(DrawTiltedPlate(device, rng));
      break;
    case Kind::kBox:
      scene.parts.push_back(BrownBox(DrawBox(device, name.size_mm, rng)));
      break;
    case Kind::kWhiteBox:
      scene.parts.push_back(WhiteBox(DrawBox(device, name.size_mm, rng)));
      break;
    case Kind::kCylinder: {
      const Spot spot = DrawSpot(device, name.size_mm, rng);
      scene.parts.push_back(LyingCylinder(name.size_mm, 0.35 * spot.size.x(), spot.centre, spot.yaw));
      break;
    }
    case Kind::kSphere:
      scene.parts.push_back(HalfSphere(name.size_mm, DrawSpot(device, 0.5 * name.size_mm, rng).centre));
      break;
    case Kind::kHand:
      AddHand(device, name, people_seed, scene);
      break;
  }
  const double up = Find(name.modifiers, Modifier::kHigh).value_or(0.0);
  const double aside = Find(name.modifiers, Modifier::kSide).value_or(0.0);
  if (up != 0.0 || aside != 0.0) MoveObjects({0.0, aside, up}, scene);
  return scene;
}

}  // namespace dorsum
