// SPDX-License-Identifier: Apache-2.0
#include "studio/calibration_outcome.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/files.h"
#include "calibration/bundle_verdicts.h"
#include "captures/image_file.h"
#include "report/board_pictures.h"
#include "report/sheet_residual_pictures.h"
#include "studio/fitted_picture.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr int kBoardWidth_px = 1000;

std::vector<cv::Point2f> ToPoints(const std::vector<Eigen::Vector2d>& points) {
  std::vector<cv::Point2f> out;
  out.reserve(points.size());
  for (const Eigen::Vector2d& p : points) {
    out.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  return out;
}

Status DrawBoards(const BundleCalibration& bundle, const fs::path& dir, const Context& context,
                  CalibrationOutcome* outcome) {
  const auto expected = ExpectedCorners(bundle.data, bundle.solution.state);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    const BoardView& view = bundle.data.boards[i];
    const auto path = FindImage(dir, view.name);
    if (!path) continue;
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat photo, ReadImage(*path));
    outcome->boards.push_back({QString::fromStdString(view.name), bundle.view_rms_px.at(i),
                               FittedPicture::ImageOf(DrawReprojection(
                                   photo, ToPoints(view.corners), ToPoints(expected[i]), kBoardWidth_px))});
  }
  return {};
}

void DrawSheets(const std::vector<SheetResidual>& residuals, CalibrationOutcome* outcome) {
  if (residuals.empty()) return;
  std::set<int> lasers;
  for (const SheetResidual& r : residuals) lasers.insert(r.laser);
  const SheetResidualScales scales = ScalesOf(residuals);
  for (const int laser : lasers) {
    outcome->sheets.push_back({laser,
                               FittedPicture::ImageOf(DrawSheetResidualsOverOrder(residuals, laser, scales)),
                               FittedPicture::ImageOf(DrawSheetResidualsOverY(residuals, laser, scales))});
  }
}

// What is about to be replaced; nothing where there is nothing.
std::optional<std::string> Earlier(const fs::path& file) {
  Result<std::string> bytes = ReadFile(file);
  return bytes.ok() ? std::optional(std::move(bytes).value()) : std::nullopt;
}

}  // namespace

std::vector<FigureChange> CompareFigures(const std::vector<PartReport>& before,
                                         const std::vector<PartReport>& after) {
  std::vector<FigureChange> changes;
  for (const PartReport& part : after) {
    for (const Figure& f : part.figures) changes.push_back({part.part, f.name, f.unit, {}, f.value});
  }
  for (const PartReport& part : before) {
    for (const Figure& f : part.figures) {
      const auto same = std::find_if(changes.begin(), changes.end(), [&](const FigureChange& c) {
        return c.part == part.part && c.figure == f.name && c.unit == f.unit;
      });
      if (same != changes.end()) {
        same->before = f.value;
      } else {
        changes.push_back({part.part, f.name, f.unit, f.value, {}});
      }
    }
  }
  return changes;
}

fs::path BeforePath(const fs::path& file) {
  fs::path before = file;
  before.replace_extension();
  before += ".before";
  before += file.extension();
  return before;
}

Result<std::shared_ptr<const CalibrationOutcome>> CalibrateForWindow(
    const fs::path& dir, const fs::path& file, const std::optional<std::vector<PartReport>>& before,
    const Context& context) {
  std::error_code ec;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ec);
  if (ec) return BadInput("cannot make the folder " + file.parent_path().string() + ": " + ec.message());
  fs::path page = file;
  page.replace_extension(".html");
  const auto earlier = Earlier(file), earlier_page = Earlier(page);
  DORSUM_ASSIGN_OR_RETURN(const CalibrationRun run, CalibrateFolder(dir, file, {}, context));
  if (earlier) DORSUM_RETURN_IF_ERROR(WriteFile(BeforePath(file), *earlier));
  if (earlier_page) DORSUM_RETURN_IF_ERROR(WriteFile(BeforePath(page), *earlier_page));
  auto outcome = std::make_shared<CalibrationOutcome>();
  outcome->file = file;
  outcome->parts = run.calibration.parts;
  outcome->warnings = run.calibration.warnings;
  outcome->has_before = before.has_value();
  outcome->changes = CompareFigures(before.value_or(std::vector<PartReport>{}), run.calibration.parts);
  if (run.bundle) {
    DORSUM_RETURN_IF_ERROR(DrawBoards(*run.bundle, dir, context, outcome.get()));
    DrawSheets(run.bundle->residuals, outcome.get());
  }
  return std::shared_ptr<const CalibrationOutcome>(std::move(outcome));
}

}  // namespace dorsum
