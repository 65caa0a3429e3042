// SPDX-License-Identifier: Apache-2.0
#include "simulator/disturbance.h"

#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "base/random.h"

namespace dorsum {
namespace {

constexpr double kDimShare = 0.3;

// Somewhere in the inner two thirds of the fan, where an object lies.
DirtySpot DrawSpot(const VirtualLaser& laser, Rng& rng) {
  const double edge = std::sin(laser.half_angle);
  DirtySpot spot;
  spot.beta = rng.Uniform(-0.35, 0.35) * edge;
  spot.half_width = rng.Uniform(0.05, 0.09) * edge;
  spot.transmission = rng.Uniform(0.04, 0.15);
  return spot;
}

void Turn(double degrees, Rng& rng, Camera& camera) {
  const double x = rng.Normal(), y = rng.Normal(), z = rng.Normal();
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180.0, Eigen::Vector3d(x, y, z).normalized());
  const Rigid3 error{turn.toRotationMatrix(), Eigen::Vector3d::Zero()};
  camera.camera_from_world = error * camera.camera_from_world;
}

}  // namespace

VirtualDevice Disturb(VirtualDevice device, const SceneModifiers& modifiers, std::uint64_t seed) {
  for (const SceneModifier& modifier : modifiers) {
    const std::string word(RuleOf(modifier.kind).word);
    if (RuleOf(modifier.kind).number == ModifierRule::Number::kLaser) {
      const auto k = static_cast<std::size_t>(modifier.value);
      VirtualLaser& laser = device.lasers.at(k);
      Rng rng(NamedSeed(word + std::to_string(k), seed));
      if (modifier.kind == Modifier::kDust) laser.dirt.push_back(DrawSpot(laser, rng));
      const double share = modifier.kind == Modifier::kOff   ? 0.0
                           : modifier.kind == Modifier::kDim ? kDimShare
                                                             : 1.0;
      laser.power *= share;
      laser.relative_power *= share;
    }
    if (modifier.kind == Modifier::kAmbient) {
      device.description.light.ambient_laser *= modifier.value;
      device.description.light.ambient_led *= modifier.value;
    }
    if (modifier.kind == Modifier::kKnocked) {
      Rng rng(NamedSeed(word, seed));
      Turn(modifier.value, rng, device.camera);
    }
  }
  return device;
}

bool DisturbsDevice(const SceneModifiers& modifiers) {
  for (const SceneModifier& modifier : modifiers) {
    if (RuleOf(modifier.kind).number == ModifierRule::Number::kLaser || modifier.kind == Modifier::kAmbient ||
        modifier.kind == Modifier::kKnocked) {
      return true;
    }
  }
  return false;
}

std::optional<Motion> MotionOf(const SceneModifiers& modifiers, int lasers, std::uint64_t seed) {
  const auto distance = Find(modifiers, Modifier::kMoved);
  if (!distance) return std::nullopt;
  Rng rng(NamedSeed(RuleOf(Modifier::kMoved).word, seed));
  const double azimuth = rng.Uniform(0.0, 2.0 * std::numbers::pi);
  return Motion{*distance * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0), lasers / 2};
}

Status CheckLasers(const SceneModifiers& modifiers, int lasers) {
  for (const SceneModifier& modifier : modifiers) {
    const ModifierRule& rule = RuleOf(modifier.kind);
    const int k = static_cast<int>(modifier.value);
    if (rule.number != ModifierRule::Number::kLaser || k < lasers) continue;
    return UsageError("\"+" + std::string(rule.word) + std::to_string(k) + "\": the device has lasers 0 to " +
                      std::to_string(lasers - 1));
  }
  return {};
}

}  // namespace dorsum
