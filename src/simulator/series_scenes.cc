// SPDX-License-Identifier: Apache-2.0
#include "simulator/series_scenes.h"

#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "base/random.h"
#include "captures/names.h"
#include "simulator/board.h"
#include "simulator/board_poses.h"

namespace dorsum {
namespace {

using Thing = SeriesStep::Thing;

std::uint64_t SeriesSeed(const VirtualDevice& device) { return NamedSeed("calibration", device.seed); }

Result<Scene> BoardScene(const VirtualDevice& device, int view) {
  const BoardDesign& board = device.description.board;
  DORSUM_ASSIGN_OR_RETURN(const auto poses,
                          DrawBoardPoses(device, view + 1, NamedSeed("boards", SeriesSeed(device))));
  Scene scene;
  scene.parts.push_back(Backplane());
  if (view == 0) {
    LayChessboard(board, poses[0], scene.parts[0]);
  } else {
    scene.parts.push_back(ChessboardPlate(board, poses.back()));
  }
  return scene;
}

// The top of the calibration object, which is wider than the picture.
ScenePart Object(const VirtualDevice& device, double height_mm) {
  BoxPlace place;
  place.height_mm = height_mm;
  const Eigen::AlignedBox2d seen = VisibleRectangle(device.camera, 0.0, -0.2);
  place.centre_mm = seen.center();
  place.size_mm = 1.5 * seen.sizes();
  return WhiteBox(place);
}

// The empty plane at one of the two distances, or the board on it on a laser's central stripe.
Scene PlaneScene(const VirtualDevice& device, const SeriesStep& step) {
  const bool further = step.thing == Thing::kBackplane || step.thing == Thing::kBoardOnBackplane;
  Scene scene;
  scene.parts.push_back(further ? Backplane() : Object(device, step.height_mm));
  if (step.thing == Thing::kBoardOnBackplane || step.thing == Thing::kBoardOnObject) {
    const std::string name = LaserChessName(step.number, further ? Distance::kFurther : Distance::kCloser);
    const DiffractedFan& fan = device.lasers.at(static_cast<std::size_t>(step.number)).fan;
    const Rigid3 pose = BoardOnStripe(fan, step.height_mm, NamedSeed("place/" + name, SeriesSeed(device)));
    LayChessboard(device.description.board, pose, scene.parts[0]);
  }
  return scene;
}

// A sheet with one line per laser, drawn by hand where its central stripe runs (§3.2).
Scene LinesScene(const VirtualDevice& device) {
  Rng rng(NamedSeed("lines", SeriesSeed(device)));
  const double length = 0.62 * VisibleRectangle(device.camera, 0.0).sizes().y();
  std::vector<DrawnLine> lines;
  for (const VirtualLaser& laser : device.lasers) {
    const StripePointOnPlane at = CentralStripeAt(laser.fan, 0.0, rng.Uniform(-3.0, 3.0));
    DrawnLine line;
    line.middle = at.point + rng.Uniform(-0.6, 0.6) * Eigen::Vector3d::UnitX();
    line.direction = Eigen::AngleAxisd(rng.Uniform(-0.003, 0.003), Eigen::Vector3d::UnitZ()) * at.direction;
    line.length_mm = length;
    line.width_mm = 1.0;
    lines.push_back(line);
  }
  Scene scene;
  scene.parts.push_back(Backplane());
  DrawLines(lines, scene.parts[0]);
  return scene;
}

// A box nearly as wide as the picture, so that the correction polynomial (3.6-3.9) has samples at every x.
Scene BoxScene(const VirtualDevice& device, double height_mm) {
  Rng rng(NamedSeed(std::string(kHeightsFolder) + "/" + HeightFolderName(height_mm), SeriesSeed(device)));
  const Eigen::AlignedBox2d seen = VisibleRectangle(device.camera, height_mm);
  BoxPlace place;
  const double dx = rng.Uniform(-0.015, 0.015), dy = rng.Uniform(-0.03, 0.03);
  place.centre_mm = seen.center() + Eigen::Vector2d(dx, dy).cwiseProduct(seen.sizes());
  place.size_mm = {0.86 * seen.sizes().x(), 0.7 * seen.sizes().y()};
  place.height_mm = height_mm;
  place.yaw = rng.Uniform(-1.5, 1.5) * std::numbers::pi / 180.0;
  Scene scene;
  scene.parts.push_back(Backplane());
  scene.parts.push_back(BrownBox(place));
  return scene;
}

}  // namespace

Result<Scene> BuildSeriesScene(const VirtualDevice& device, const SeriesStep& step) {
  switch (step.thing) {
    case Thing::kBoard:
      return BoardScene(device, step.number);
    case Thing::kLines:
      return LinesScene(device);
    case Thing::kBox:
      return BoxScene(device, step.height_mm);
    default:
      return PlaneScene(device, step);
  }
}

std::uint64_t SeriesPictureSeed(const VirtualDevice& device, const std::string& name) {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos) return NamedSeed(name, SeriesSeed(device));
  return NamedSeed(name.substr(slash + 1), NamedSeed(name.substr(0, slash), SeriesSeed(device)));
}

}  // namespace dorsum
