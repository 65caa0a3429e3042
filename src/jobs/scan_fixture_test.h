// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/files.h"
#include "jobs/calibrate.h"
#include "simulator/simulate.h"

namespace dorsum {

// A scan of a small virtual device for the tests that run whole jobs. Every test is a process of its own, so
// what takes seconds is made once and kept in the build folder until the code that makes it changes.
class ScanFixture {
 public:
  // Three lasers, whole field of view, as few pixels as the classic method still copes with: the stripes of
  // one laser lie 27 px apart and are 2.5 px wide.
  static constexpr const char* kDevice = R"(
name = "small"
[camera]
resolution_px = [560, 420]
focal_length_px = 728.0
format = "png"
[mounting]
principal_point_px = 3.0
[calibration]
box_heights_mm = [10.0, 25.0, 40.0]
[[laser]]
position_mm = [-11.15, 0.0, 395.0]
[[laser]]
position_mm = [0.0, 0.0, 395.0]
[[laser]]
position_mm = [11.15, 0.0, 395.0]
[[led]]
position_mm = [-430.0, 330.0, 940.0]
[[led]]
position_mm = [440.0, 310.0, 940.0]
[[led]]
position_mm = [0.0, -520.0, 940.0]
)";
  static constexpr const char* kSeed = "1";
  static constexpr const char* kBox = "box25.5";
  static constexpr const char* kSphere = "sphere40";
  static constexpr const char* kHand = "hand_woman_right_anna";
  static constexpr const char* kKnocked = "box25.5+knocked1";
  static constexpr const char* kMoved = "hand_woman_right_anna+moved3";
  static constexpr const char* kHigh = "hand_woman_right_anna+high";

  // Folder with device.toml, calibration/, captures/ and truth/. Not to be changed: copy what you change.
  static std::filesystem::path Scan() {
    return Cached("scan", std::string(kDevice) + kSeed + kKnocked + kMoved + kHigh + LibraryStamps(),
                  [](const std::filesystem::path& dir) {
                    Require(WriteFile(dir / "device.toml", kDevice));
                    SimulateOptions options;
                    options.device_path = dir / "device.toml";
                    options.seed = kSeed;
                    options.scenes = {kBox,
                                      kSphere,
                                      kKnocked,
                                      "hand:woman:right:anna",
                                      "hand:woman:right:anna+moved3",
                                      "hand:woman:right:anna+high"};
                    options.overwrite = true;
                    const Result<SimulateReport> report = Simulate(options, dir, Context{});
                    if (!report.ok()) throw std::runtime_error(report.error().message);
                  });
  }
  static std::filesystem::path CalibrationDir() { return Scan() / "calibration"; }
  static std::filesystem::path CaptureDir(const std::string& name) { return Scan() / "captures" / name; }
  static std::filesystem::path ReferencePly(const std::string& name) {
    return Scan() / "truth" / name / "reference.ply";
  }

  // calibration.json of that scan, made by this very test program.
  static std::filesystem::path CalibrationJson() {
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
    const std::string name = "calibration_by_" + self.filename().string();
    const std::filesystem::path scan = Scan();
    return Cached(name, kDevice + LibraryStamps() + Stamp(self),
                  [&](const std::filesystem::path& dir) {
                    const auto run = CalibrateFolder(scan / "calibration", dir / "calibration.json", {}, {});
                    if (!run.ok()) throw std::runtime_error(run.error().message);
                  }) /
           "calibration.json";
  }

  static void CopyFolder(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::filesystem::create_directories(to);
    std::filesystem::copy(from, to, std::filesystem::copy_options::recursive);
  }

 private:
  static void Require(const Status& status) {
    if (!status.ok()) throw std::runtime_error(status.error().message);
  }

  static std::string Stamp(const std::filesystem::path& file) {
    const auto time = std::filesystem::last_write_time(file).time_since_epoch().count();
    return file.string() + " " + std::to_string(std::filesystem::file_size(file)) + " " +
           std::to_string(time) + "\n";
  }

  // Of the libraries that render: with them changes what they make.
  static std::string LibraryStamps() {
    std::string stamps, paths = DORSUM_TEST_RENDERERS;
    for (std::size_t at = 0; at < paths.size();) {
      const std::size_t end = std::min(paths.find('|', at), paths.size());
      stamps += Stamp(paths.substr(at, end - at));
      at = end + 1;
    }
    return stamps;
  }

  // DORSUM_TEST_CACHE/name, filled by `make` unless an earlier process did so with the same stamp. One
  // process makes it, and those that run beside it wait.
  static std::filesystem::path Cached(const std::string& name, const std::string& stamp,
                                      const std::function<void(const std::filesystem::path&)>& make) {
    const std::filesystem::path root = DORSUM_TEST_CACHE;
    std::filesystem::path dir = root / name;
    std::filesystem::create_directories(root);
    const int lock = open((root / (name + ".lock")).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (lock < 0 || flock(lock, LOCK_EX) != 0) throw std::runtime_error("cannot lock " + dir.string());
    const std::filesystem::path mark = root / (name + ".stamp");
    const Result<std::string> old = ReadFile(mark);
    if (!old.ok() || *old != stamp) {
      std::filesystem::remove(mark);
      std::filesystem::remove_all(dir);
      std::filesystem::create_directories(dir);
      make(dir);
      Require(WriteFile(mark, stamp));
    }
    close(lock);
    return dir;
  }
};

}  // namespace dorsum
