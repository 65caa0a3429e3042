// SPDX-License-Identifier: Apache-2.0
#include "report/calibration_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "report/board_pictures.h"
#include "report/correction_pictures.h"
#include "report/drawing.h"
#include "report/html.h"
#include "report/photo_pictures.h"
#include "report/sheet_residual_pictures.h"

namespace dorsum {
namespace {

std::string LaserName(int laser) { return "Laser " + std::to_string(laser); }

void AddVerdict(HtmlPage& page, const CalibrationReportData& data) {
  const auto count = [&](Grade grade) {
    return std::to_string(std::count_if(data.parts.begin(), data.parts.end(),
                                        [&](const PartReport& part) { return part.grade == grade; }));
  };
  page.Warnings(data.warnings);
  std::set<int> lasers;
  for (const LaserCalibration& laser : data.classic.lasers) lasers.insert(laser.laser);
  for (const SheetResidual& r : data.residuals) lasers.insert(r.laser);
  std::vector<HtmlFact> facts = {{"Lasers", std::to_string(lasers.size()), ""},
                                 {"Board views", std::to_string(data.classic.camera.views.size()), ""}};
  if (data.sources > 0) facts.push_back({"Files read", std::to_string(data.sources), ""});
  if (!data.parts.empty()) {
    facts.push_back({"Good parts", count(Grade::kGood), "of " + std::to_string(data.parts.size())});
    facts.push_back({"Doubtful", count(Grade::kDoubtful), ""});
    facts.push_back({"Bad", count(Grade::kBad), ""});
  }
  page.Facts(facts);
  if (data.parts.empty()) return;
  page.Section("Verdict", "Each part of the device judges itself by what its own model leaves unexplained.");
  page.Verdicts(data.parts);
}

HtmlTable ViewTable(const CameraCalibration& camera) {
  HtmlTable table;
  table.header = {"View", "Reprojection error (px)"};
  table.caption = "One view that stands out is often blurred, or the board moved or bent.";
  double largest = 1e-9;
  for (const double rms : camera.view_rms_px) largest = std::max(largest, rms);
  for (std::size_t i = 0; i < std::min(camera.views.size(), camera.view_rms_px.size()); ++i) {
    table.rows.push_back(
        {camera.views[i], {FormatNumber(camera.view_rms_px[i], 3), camera.view_rms_px[i] / largest}});
  }
  return table;
}

void AddCamera(HtmlPage& page, const CalibrationReportData& data) {
  const CameraCalibration& camera = data.classic.camera;
  if (camera.corners.empty() && data.board_photo.empty()) return;
  page.Section("Camera",
               "The camera learns its lens and its place from pictures of a chessboard. The reprojection "
               "error says how "
               "far, in pixels, the corners lie from where the model expects them.");
  std::vector<HtmlFigure> figures;
  if (!data.board_photo.empty()) {
    const std::vector<cv::Point2f> seen =
        camera.corners.empty() ? std::vector<cv::Point2f>{} : camera.corners.front();
    figures.push_back(
        {DrawReprojection(data.board_photo, seen,
                          ReprojectBoard(camera.camera, seen, data.board_inner, data.square_mm)),
         ImageKind::kPhoto, "The first board, which fixes the world.",
         "Every inner corner should have a ring. Arrows in all directions are noise; arrows that turn "
         "together speak of a bent board or a lens that the model does not fit."});
  }
  cv::Size size(camera.camera.width, camera.camera.height);
  if (size.empty()) size = data.board_photo.size();
  if (!camera.corners.empty()) {
    figures.push_back(
        {DrawCornerCoverage(size, camera.corners), ImageKind::kDrawing, "Where corners were seen.",
         "The whole image with the corners of all views, one colour for each. Large empty places, above "
         "all at the edges, are places where the lens is only guessed."});
  }
  page.Figures(figures);
  page.Table(ViewTable(camera));
}

HtmlTable LaserTable(const std::vector<LaserCalibration>& lasers) {
  HtmlTable table;
  table.header = {"Laser",
                  "Spacing far (mm)",
                  "Spacing near (mm)",
                  "Grating height (mm)",
                  "Central stripe x (mm)",
                  "Guessed x (mm)",
                  "Orders on the backplane"};
  table.caption =
      "The nearer plane shows the stripes closer together; from the ratio follows how high the grating "
      "is (equation 3.4).";
  for (const LaserCalibration& laser : lasers) {
    const auto& lines = laser.background.lines;
    table.rows.push_back(
        {std::to_string(laser.laser), FormatNumber(laser.grating.spacing_further_mm, 3),
         FormatNumber(laser.grating.spacing_closer_mm, 3), FormatNumber(laser.grating.height_mm, 2),
         FormatNumber(laser.central_x_mm, 2), FormatNumber(laser.first_estimate_mm, 2),
         lines.empty() ? "-"
                       : std::to_string(lines.front().order) + " to " + std::to_string(lines.back().order)});
  }
  return table;
}

void AddLasers(HtmlPage& page, const CalibrationReportData& data) {
  if (data.classic.lasers.empty()) return;
  page.Section(
      "Lasers and gratings",
      "Each laser's stripes are measured on the backplane and on a nearer plane, in views straightened as if "
      "seen from above. Every stripe should carry one line, and none should be skipped.");
  page.Table(LaserTable(data.classic.lasers));
  std::vector<HtmlFigure> strips, backgrounds;
  for (const LaserCalibration& laser : data.classic.lasers) {
    if (!laser.further.picture.empty()) {
      strips.push_back({laser.further.picture, ImageKind::kPhoto, LaserName(laser.laser) + ", far plane.",
                        "Stripes on the backplane."});
    }
    if (!laser.closer.picture.empty()) {
      strips.push_back({laser.closer.picture, ImageKind::kPhoto, LaserName(laser.laser) + ", near plane.",
                        "The same stripes on the calibration object."});
    }
    const auto k = static_cast<std::size_t>(laser.laser);
    if (laser.background.stripes.segments.empty()) continue;
    const cv::Mat photo =
        laser.laser >= 0 && k < data.background_photos.size() ? data.background_photos[k] : cv::Mat();
    backgrounds.push_back({DrawIndexedStripes(photo, laser.background.stripes), ImageKind::kPhoto,
                           LaserName(laser.laser) + " on the empty backplane.",
                           std::to_string(laser.background.lines.size()) + " stripes."});
  }
  page.Figures(strips);
  if (backgrounds.empty()) return;
  page.Section(
      "Reference stripes",
      "The stripes as they lie when nothing is there; all heights are counted from them. Order 0, in white, "
      "must be the brightest stripe, and numbers must grow by one to the right without a gap.");
  page.Figures(backgrounds);
}

HtmlTable ResidualTable(const std::vector<SheetResidual>& residuals) {
  std::map<std::pair<int, double>, std::pair<double, std::pair<double, int>>> cells;
  for (const SheetResidual& r : residuals) {
    if (std::abs(r.miss_mm) > 0.5) continue;
    auto& [sum, more] = cells[{r.laser, r.height_mm}];
    sum += r.miss_mm;
    more.first += r.miss_mm * r.miss_mm;
    ++more.second;
  }
  HtmlTable table;
  table.header = {"Laser", "Height (mm)", "Points", "Mean (mm)", "RMS (mm)"};
  for (const auto& [key, cell] : cells) {
    const double n = cell.second.second;
    table.rows.push_back({std::to_string(key.first), FormatNumber(key.second, 1),
                          std::to_string(cell.second.second), FormatNumber(cell.first / n, 4),
                          FormatNumber(std::sqrt(cell.second.first / n), 4)});
  }
  return table;
}

void AddResiduals(HtmlPage& page, const std::vector<SheetResidual>& residuals) {
  if (residuals.empty()) return;
  page.Section(
      "Light sheets",
      "How far each stripe point on a plane of known height lies off its light sheet, in micrometres on that "
      "plane: dots are points, lines their means, one colour for each height. Noise alone scatters evenly "
      "about "
      "zero. Lines that bend together along y speak of a wrong form of the fan, lines that fan out with the "
      "height of a wrong height or a laser that moved.");
  std::set<int> lasers;
  for (const SheetResidual& r : residuals) lasers.insert(r.laser);
  const SheetResidualScales scales = ScalesOf(residuals);
  for (const int laser : lasers) {
    page.Figures({{DrawSheetResidualsOverY(residuals, laser, scales), ImageKind::kDrawing,
                   LaserName(laser) + ", along the stripes."},
                  {DrawSheetResidualsOverOrder(residuals, laser, scales), ImageKind::kDrawing,
                   LaserName(laser) + ", order by order."}});
  }
  page.Table(ResidualTable(residuals));
}

void AddCorrection(HtmlPage& page, const std::vector<LaserCorrection>& correction) {
  if (correction.empty()) return;
  page.Section(
      "Correction of heights",
      "Boxes of known height show how far the plain model is off, and where: each dot is a place on a box, "
      "rows of dots are "
      "boxes of one height, red is too high, blue too low. A polynomial of second order in x and z (equation "
      "3.7) is "
      "fitted to that error; it should look like the dots, smoothed, and deep colours where there are no "
      "dots are "
      "guesses. What is left should be pale all over: a pattern is an error that stays in every scan.");
  HtmlTable table;
  table.header = {"Laser",          "Samples",          "RMS before (mm)",
                  "RMS after (mm)", "Mean before (mm)", "Mean after (mm)"};
  for (const LaserCorrection& one : correction) {
    table.rows.push_back({std::to_string(one.laser), std::to_string(one.fit.samples),
                          FormatNumber(one.fit.rms_before_mm, 3), FormatNumber(one.fit.rms_after_mm, 3),
                          FormatNumber(one.fit.mean_before_mm, 3), FormatNumber(one.fit.mean_after_mm, 3)});
  }
  page.Table(table);
  for (const LaserCorrection& one : correction) {
    const CorrectionScales scales = ScalesOf(one.samples);
    const std::string name = LaserName(one.laser);
    page.Figures({{DrawCorrectionSamples(one.samples, scales), ImageKind::kDrawing, name + ": as measured."},
                  {DrawCorrectionPolynomial(one.fit.polynomial, scales), ImageKind::kDrawing,
                   name + ": the fitted polynomial."},
                  {DrawCorrectionSamples(one.samples, scales, one.fit.polynomial), ImageKind::kDrawing,
                   name + ": what is left."}},
                 3);
  }
}

}  // namespace

std::string MakeCalibrationReport(const CalibrationReportData& data) {
  HtmlPage page(
      data.title.empty() ? "Calibration" : data.title,
      "Camera, lasers and gratings of one device" + (data.method.empty() ? "" : "; method: " + data.method));
  AddVerdict(page, data);
  AddEvaluation(page, data.evaluation);
  AddCamera(page, data);
  AddResiduals(page, data.residuals);
  AddLasers(page, data);
  AddCorrection(page, data.correction);
  if (!data.settings.empty()) {
    page.Section("How it was made");
    page.Table(RowsTable(data.settings));
  }
  return page.Finish(data.version.empty() ? "Dorsum" : "Dorsum " + data.version);
}

}  // namespace dorsum
