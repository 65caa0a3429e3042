// SPDX-License-Identifier: Apache-2.0
#include "simulator/board_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "base/random.h"
#include "simulator/board.h"
#include "simulator/scene.h"

namespace dorsum {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

// The four outer corners of the paper, or of the printed squares.
std::array<Eigen::Vector3d, 4> Corners(const Rigid3& world_from_board, const Eigen::Vector2d& size) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y();
  return {world_from_board * Eigen::Vector3d(-x, -y, 0.0), world_from_board * Eigen::Vector3d(x, -y, 0.0),
          world_from_board * Eigen::Vector3d(x, y, 0.0), world_from_board * Eigen::Vector3d(-x, y, 0.0)};
}

bool InPicture(const Camera& camera, const Rigid3& world_from_board, const Eigen::Vector2d& squares) {
  const double margin = 0.01 * camera.width;
  for (const Eigen::Vector3d& corner : Corners(world_from_board, squares)) {
    const Eigen::Vector2d p = Project(camera, corner);
    if (!(p.x() > margin && p.y() > margin && p.x() < camera.width - 1 - margin &&
          p.y() < camera.height - 1 - margin)) {
      return false;
    }
  }
  return true;
}

Rigid3 DrawTilted(const Camera& camera, const Eigen::Vector2d& sheet, int view, Rng& rng) {
  // Directions of the tilt go round evenly, so that no series lacks one.
  const double azimuth = 2.0 * std::numbers::pi * (view * 0.381966 + rng.Uniform(-0.08, 0.08));
  const double tilt = rng.Uniform(9.0, 25.0) * kRadian;
  const double yaw = rng.Uniform(-22.0, 22.0) * kRadian;
  const Eigen::Vector3d axis(std::cos(azimuth), std::sin(azimuth), 0.0);
  Rigid3 pose;
  pose.rotation =
      (Eigen::AngleAxisd(tilt, axis) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())).toRotationMatrix();
  double lowest = 0.0;
  for (const Eigen::Vector3d& corner : Corners(pose, sheet)) lowest = std::min(lowest, corner.z());
  const double z = -lowest + rng.Uniform(4.0, 30.0);
  const Eigen::AlignedBox2d seen = VisibleRectangle(camera, z);
  const double x = rng.Uniform(seen.min().x(), seen.max().x()),
               y = rng.Uniform(seen.min().y(), seen.max().y());
  pose.translation = {x, y, z};
  return pose;
}

}  // namespace

Result<std::vector<Rigid3>> DrawBoardPoses(const VirtualDevice& device, int count, std::uint64_t seed) {
  const BoardDesign& board = device.description.board;
  const Eigen::Vector2d sheet = BoardSheetSize(board);
  const Eigen::Vector2d squares = board.square_mm * Eigen::Vector2d(board.columns + 1, board.rows + 1);
  constexpr int kTries = 4000;
  std::vector<Rigid3> poses(1);
  Rng yaw_rng(NamedSeed("yaw", seed));
  poses[0].rotation =
      Eigen::AngleAxisd(0.4 * kRadian * yaw_rng.Normal(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  bool fits = InPicture(device.camera, poses[0], squares);
  for (int view = 1; view < count && fits; ++view) {
    Rng rng(NamedSeed("view" + std::to_string(view), seed));
    fits = false;
    for (int i = 0; i < kTries && !fits; ++i) {
      const Rigid3 pose = DrawTilted(device.camera, sheet, view, rng);
      fits = InPicture(device.camera, pose, squares);
      if (fits) poses.push_back(pose);
    }
  }
  if (fits) return poses;
  return BadInput("the chessboard of " + std::to_string(board.columns + 1) + " x " +
                  std::to_string(board.rows + 1) + " squares does not fit into the picture of device \"" +
                  device.description.name + "\"; make board.square_mm or camera.focal_length_px smaller");
}

Rigid3 BoardOnStripe(const DiffractedFan& fan, double z, std::uint64_t seed) {
  Rng rng(seed);
  const StripePointOnPlane at = CentralStripeAt(fan, z, rng.Uniform(-3.0, 3.0));
  const double turn = std::atan2(-at.direction.x(), at.direction.y()) + 0.3 * kRadian * rng.Normal();
  Rigid3 pose;
  pose.rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation = at.point + 0.15 * rng.Normal() * pose.rotation.col(0);
  return pose;
}

}  // namespace dorsum
