// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>

#include "base/files.h"
#include "base/median.h"
#include "calibration/chessboard.h"
#include "captures/calibration_series.h"
#include "captures/green_channel.h"
#include "captures/names.h"
#include "jobs/calibrate.h"
#include "speed/benches.h"
#include "speed/child_process.h"

namespace dorsum::speed {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double Ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Every board of the series, as calibration looks at them.
Status FindAllCorners(const CalibrationSeries& series) {
  std::vector<std::string> names = series.chess_views;
  for (const int laser : series.lasers) {
    for (const Distance d : {Distance::kFurther, Distance::kCloser})
      names.push_back(LaserChessName(laser, d));
  }
  for (const std::string& name : names) {
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat image, series.Read(name));
    if (!FindChessboard(GreenChannel(image), {series.setup.board_columns, series.setup.board_rows})) {
      return BadInput("no board in " + name);
    }
  }
  return {};
}

}  // namespace

Result<Measured> TimeCalibration(const SpeedScene& scene) {
  std::vector<double> corners, bundle;
  for (int i = 0; i < 3; ++i) {
    const Stopwatch watch;
    DORSUM_ASSIGN_OR_RETURN(const CalibrationSeries series, LoadCalibrationSeries(scene.calibration_dir));
    DORSUM_RETURN_IF_ERROR(FindAllCorners(series));
    corners.push_back(watch.Ms());
    const Stopwatch again;
    DORSUM_RETURN_IF_ERROR(CalibrateSeries(series, {}, {}));
    bundle.push_back(again.Ms());
  }
  return Measured{{"calibrate/corners", Median(corners)}, {"calibrate/bundle", Median(bundle)}};
}

Result<Measured> TimeProcesses(const SpeedScene& scene, const fs::path& program, const fs::path& imread,
                               int captures, const fs::path& work) {
  std::error_code ec;
  fs::remove_all(work, ec);
  for (int i = 0; i < captures; ++i) {
    const fs::path to = work / "captures" / std::to_string(i);
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(scene.capture_dir)) {
      fs::create_symlink(entry.path(), to / entry.path().filename());
    }
  }
  std::vector<std::string> reading = {imread};
  for (const auto& entry : fs::directory_iterator(scene.capture_dir)) reading.push_back(entry.path());
  const auto reconstruct = [&](const fs::path& from, const fs::path& to) {
    return std::vector<std::string>{program, "reconstruct", from,          "-c", scene.calibration_path,
                                    "-o",    work / to,     "--no-report", "-q"};
  };
  Measured out;
  std::vector<double> one, bare;
  for (int i = 0; i < 7; ++i) {
    DORSUM_ASSIGN_OR_RETURN(const ChildUse a, RunChild(reconstruct(scene.capture_dir, "one")));
    DORSUM_ASSIGN_OR_RETURN(const ChildUse b, RunChild(reading));
    one.push_back(1e3 * a.seconds);
    bare.push_back(1e3 * b.seconds);
    out["process/peak_mb"] = std::max(out["process/peak_mb"], a.peak_mb);
  }
  out["process/reconstruct"] = Median(one);
  out["process/imread"] = Median(bare);
  if (captures == 0) return out;
  const Stopwatch alone;
  for (int i = 0; i < captures; ++i) {
    const std::string name = std::to_string(i);
    DORSUM_RETURN_IF_ERROR(RunChild(reconstruct(work / "captures" / name, fs::path("alone") / name)));
  }
  out["batch/one_by_one"] = alone.Ms();
  std::vector<std::string> batch = reconstruct(work / "captures", "together");
  batch.emplace_back("--batch");
  DORSUM_ASSIGN_OR_RETURN(const ChildUse together, RunChild(batch));
  out["batch/together"] = 1e3 * together.seconds;
  out["batch/captures"] = captures;
  fs::remove_all(work, ec);
  return out;
}

}  // namespace dorsum::speed
