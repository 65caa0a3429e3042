// SPDX-License-Identifier: Apache-2.0
#include "simulator/calibration_writer.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "base/json.h"
#include "base/random.h"
#include "captures/names.h"
#include "captures/setup.h"
#include "simulator/board.h"
#include "simulator/board_poses.h"
#include "simulator/capture_writer.h"
#include "simulator/renderer.h"
#include "simulator/truth_files.h"

namespace dorsum {
namespace {

class SeriesWriter {
 public:
  SeriesWriter(const VirtualDevice& device, std::filesystem::path dir, const Context& context)
      : device_(device),
        dir_(std::move(dir)),
        context_(context),
        seed_(NamedSeed("calibration", device.seed)) {
    const std::size_t boxes = device.description.box_heights_mm.size();
    total_ = kChessViews + 4.0 + static_cast<double>(device.lasers.size() * (5 + boxes) + boxes);
  }

  Status WriteAll() {
    DORSUM_RETURN_IF_ERROR(MakeFolder(dir_));
    DORSUM_RETURN_IF_ERROR(WriteJson(dir_ / kSetupName, SetupToJson(SetupOf(device_.description))));
    DORSUM_RETURN_IF_ERROR(WriteChessboards());
    DORSUM_RETURN_IF_ERROR(WriteDistance(Distance::kFurther));
    DORSUM_RETURN_IF_ERROR(WriteDistance(Distance::kCloser));
    DORSUM_RETURN_IF_ERROR(WriteFirstEstimates());
    for (const double height : device_.description.box_heights_mm) DORSUM_RETURN_IF_ERROR(WriteBox(height));
    return {};
  }

 private:
  using Render = std::function<Result<cv::Mat>(std::uint64_t seed)>;

  static Setup SetupOf(const DeviceDescription& d) {
    Setup setup;
    setup.board_columns = d.board.columns;
    setup.board_rows = d.board.rows;
    setup.square_mm = d.board.square_mm;
    setup.calibration_object_height_mm = d.calibration_object_height_mm;
    setup.box_heights_mm = d.box_heights_mm;
    setup.grating_lines_per_mm = d.grating.lines_per_mm;
    setup.wavelength_nm = d.grating.wavelength_nm;
    setup.width = d.camera.width;
    setup.height = d.camera.height;
    return setup;
  }

  Status Write(const std::string& name, const Render& render) {
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat picture, render(NamedSeed(name, seed_)));
    context_.Report("calibration series", ++done_ / total_);
    return WritePicture(device_.description.camera, picture, dir_ / name);
  }
  Status WriteLeds(const std::string& name, const Stage& stage) {
    return Write(name, [&](std::uint64_t seed) { return RenderLeds(device_, stage, seed, context_); });
  }
  Status WriteDark(const std::string& name, const Stage& stage) {
    return Write(name, [&](std::uint64_t seed) { return RenderDark(device_, stage, seed, context_); });
  }
  Status WriteLaser(const std::string& name, const Stage& stage, int laser) {
    return Write(name,
                 [&](std::uint64_t seed) { return RenderLaser(device_, stage, laser, seed, context_); });
  }

  // A scene of which only the view under the LEDs is wanted.
  Status WriteLedScene(const std::string& name, Scene scene) {
    DORSUM_ASSIGN_OR_RETURN(const Stage stage, SetStage(device_, std::move(scene), context_));
    return WriteLeds(name, stage);
  }

  Status WriteChessboards() {
    const BoardDesign& board = device_.description.board;
    DORSUM_ASSIGN_OR_RETURN(const auto poses,
                            DrawBoardPoses(device_, kChessViews, NamedSeed("boards", seed_)));
    for (int view = 0; view < kChessViews; ++view) {
      Scene scene;
      scene.parts.push_back(Backplane());
      const Rigid3& pose = poses[static_cast<std::size_t>(view)];
      if (view == 0) {
        LayChessboard(board, pose, scene.parts[0]);
      } else {
        scene.parts.push_back(ChessboardPlate(board, pose));
      }
      DORSUM_RETURN_IF_ERROR(WriteLedScene(ChessName(view), std::move(scene)));
    }
    return {};
  }

  // The plane at one of the two distances: the backplane, or the top of the calibration object, which is
  // wider than the picture.
  ScenePart Screen(Distance distance) const {
    if (distance == Distance::kFurther) return Backplane();
    BoxPlace place;
    place.height_mm = device_.description.calibration_object_height_mm;
    const Eigen::AlignedBox2d seen = VisibleRectangle(device_.camera, 0.0, -0.2);
    place.centre_mm = seen.center();
    place.size_mm = 1.5 * seen.sizes();
    return WhiteBox(place);
  }

  Status WriteDistance(Distance distance) {
    const double z = distance == Distance::kFurther ? 0.0 : device_.description.calibration_object_height_mm;
    Scene scene;
    scene.parts.push_back(Screen(distance));
    DORSUM_ASSIGN_OR_RETURN(const Stage stage, SetStage(device_, std::move(scene), context_));
    DORSUM_RETURN_IF_ERROR(WriteDark(LaserBgName(distance), stage));
    if (distance == Distance::kFurther) DORSUM_RETURN_IF_ERROR(WriteLeds(kBgNoHandName, stage));
    for (int k = 0; k < static_cast<int>(device_.lasers.size()); ++k) {
      DORSUM_RETURN_IF_ERROR(WriteLaser(LaserCalName(k, distance), stage, k));
      if (distance == Distance::kFurther) DORSUM_RETURN_IF_ERROR(WriteLaser(StripesBgName(k), stage, k));
      const std::string name = LaserChessName(k, distance);
      Scene with_board;
      with_board.parts.push_back(Screen(distance));
      const DiffractedFan& fan = device_.lasers[static_cast<std::size_t>(k)].fan;
      LayChessboard(device_.description.board, BoardOnStripe(fan, z, NamedSeed("place/" + name, seed_)),
                    with_board.parts[0]);
      DORSUM_RETURN_IF_ERROR(WriteLedScene(name, std::move(with_board)));
    }
    return {};
  }

  // A sheet with one line per laser, drawn by hand where its central stripe runs (§3.2).
  Status WriteFirstEstimates() {
    Rng rng(NamedSeed("lines", seed_));
    const double length = 0.62 * VisibleRectangle(device_.camera, 0.0).sizes().y();
    std::vector<DrawnLine> lines;
    for (const VirtualLaser& laser : device_.lasers) {
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
    return WriteLedScene(kFirstEstimatesName, std::move(scene));
  }

  // A box nearly as wide as the picture, so that the correction polynomial (3.6-3.9) has samples at every x.
  Status WriteBox(double height) {
    const std::string folder = std::string(kHeightsFolder) + "/" + HeightFolderName(height);
    Rng rng(NamedSeed(folder, seed_));
    const Eigen::AlignedBox2d seen = VisibleRectangle(device_.camera, height);
    BoxPlace place;
    const double dx = rng.Uniform(-0.015, 0.015), dy = rng.Uniform(-0.03, 0.03);
    place.centre_mm = seen.center() + Eigen::Vector2d(dx, dy).cwiseProduct(seen.sizes());
    place.size_mm = {0.86 * seen.sizes().x(), 0.7 * seen.sizes().y()};
    place.height_mm = height;
    place.yaw = rng.Uniform(-1.5, 1.5) * std::numbers::pi / 180.0;
    Scene scene;
    scene.parts.push_back(Backplane());
    scene.parts.push_back(BrownBox(place));
    DORSUM_RETURN_IF_ERROR(
        WriteCapture(device_, std::move(scene), {}, NamedSeed(folder, seed_), dir_ / folder, {}, context_));
    done_ += 1.0 + static_cast<double>(device_.lasers.size());
    context_.Report("calibration series", done_ / total_);
    return {};
  }

  const VirtualDevice& device_;
  std::filesystem::path dir_;
  const Context& context_;
  std::uint64_t seed_;
  double done_ = 0.0, total_ = 1.0;
};

}  // namespace

Status WriteCalibrationSeries(const VirtualDevice& device, const std::filesystem::path& dir,
                              const Context& context) {
  return SeriesWriter(device, dir, context).WriteAll();
}

}  // namespace dorsum
