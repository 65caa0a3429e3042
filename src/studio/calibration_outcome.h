// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jobs/calibrate.h"

namespace dorsum {

// A figure of a part, in the calibration before and in the one now; absent where the part has none.
struct FigureChange {
  std::string part, figure, unit;
  std::optional<double> before, after;
};

// All figures of both, those of `after` first, in their order.
std::vector<FigureChange> CompareFigures(const std::vector<PartReport>& before,
                                         const std::vector<PartReport>& after);

// What a window shows of a calibration that was made now.
struct CalibrationOutcome {
  struct Board {
    QString name;
    double rms_px = 0.0;
    QImage picture;  // corners as rings, arrows to where they are expected
  };
  struct Sheets {
    int laser = 0;
    QImage over_order, over_y;  // what the light sheets leave
  };
  std::filesystem::path file;
  std::vector<PartReport> parts;
  std::vector<std::string> warnings;
  std::vector<Board> boards;
  std::vector<Sheets> sheets;
  std::vector<FigureChange> changes;
  bool has_before = false;  // a calibration was loaded before: `changes` compare with it
};

// Where the calibration that `file` held before is kept: "calibration.json" -> "calibration.before.json".
std::filesystem::path BeforePath(const std::filesystem::path& file);

// Calibrates the series in `dir` into `file`, whose folder is made; what `file` held is kept at BeforePath.
// `before`: the calibration to compare with, or none.
Result<std::shared_ptr<const CalibrationOutcome>> CalibrateForWindow(
    const std::filesystem::path& dir, const std::filesystem::path& file,
    const std::optional<std::vector<PartReport>>& before, const Context& context);

}  // namespace dorsum
