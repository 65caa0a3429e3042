// SPDX-License-Identifier: Apache-2.0
#include "jobs/board.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

#include "base/files.h"
#include "calibration/first_estimates.h"
#include "captures/designed_geometry.h"
#include "report/printed_targets.h"
#include "simulator/scene.h"
#include "simulator/virtual_device.h"

namespace dorsum {
namespace {

// Shares of the picture as the virtual device's own series has them (simulator/calibration_writer.cc).
constexpr double kLineShare = 0.62;
constexpr std::array<double, 2> kBoxShare = {0.86, 0.7};
constexpr double kObjectSpareMm = 20.0;  // of the calibration object beyond the picture, on each side

// The outline of what a camera sees of the plane at height z; none where part of the picture misses it.
std::optional<std::vector<Eigen::Vector2d>> SeenOutline(const Camera& camera, double z) {
  constexpr int kSteps = 16;  // a side, which distortion bends
  const double w = camera.width - 1.0, h = camera.height - 1.0;
  const std::array<Eigen::Vector2d, 5> corners = {Eigen::Vector2d(0.0, h), Eigen::Vector2d(w, h),
                                                  Eigen::Vector2d(w, 0.0), Eigen::Vector2d(0.0, 0.0),
                                                  Eigen::Vector2d(0.0, h)};
  std::vector<Eigen::Vector2d> outline;
  for (std::size_t side = 0; side < 4; ++side) {
    for (int i = 0; i < kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const Ray ray = CastRay(camera, (1.0 - t) * corners[side] + t * corners[side + 1]);
      const auto at = Intersect(ray, Plane{Eigen::Vector3d::UnitZ(), z});
      if (!at || !std::isfinite(*at) || *at > 1e5) return std::nullopt;
      outline.emplace_back(ray.At(*at).head<2>());
    }
  }
  return outline;
}

Eigen::AlignedBox2d Around(const std::vector<Eigen::Vector2d>& points) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points) box.extend(p);
  return box;
}

std::vector<CentralLine> CentralLines(const DeviceDescription& d) {
  std::vector<CentralLine> lines;
  for (std::size_t k = 0; k < d.lasers.size(); ++k) {
    const StripePointOnPlane at = CentralStripeAt(DesignedFan(d.lasers[k], d.grating), 0.0, 0.0);
    lines.push_back({static_cast<int>(k), at.point.x(), at.direction.head<2>().normalized()});
  }
  return lines;
}

// What a device's description says of its targets.
struct Targets {
  std::vector<PrintedSheet> sheets;
  std::vector<std::string> warnings;
};

Result<Targets> MakeTargets(const DeviceDescription& d) {
  const Camera camera = DesignedCamera(d.camera);
  BackplanePlan plan;
  const auto field = SeenOutline(camera, 0.0);
  const double highest = std::max(d.calibration_object_height_mm,
                                  *std::max_element(d.box_heights_mm.begin(), d.box_heights_mm.end()));
  if (!field || !SeenOutline(camera, highest)) {
    return BadInput("the camera of device \"" + d.name +
                    "\" does not see the backplane and the tops of all boxes in its whole picture; correct "
                    "camera.position_mm, camera.look_at_mm or the heights");
  }
  plan.field = *field;
  plan.lines = CentralLines(d);
  plan.camera_foot = d.camera.position_mm.head<2>();
  for (const double height : d.box_heights_mm) {
    const Eigen::AlignedBox2d seen = VisibleRectangle(camera, height);
    const Eigen::Vector2d half = 0.5 * Eigen::Vector2d(kBoxShare[0], kBoxShare[1]).cwiseProduct(seen.sizes());
    plan.boxes.push_back({height, {seen.center() - half, seen.center() + half}});
  }
  plan.object_height_mm = d.calibration_object_height_mm;
  plan.object_size_mm = Around(*SeenOutline(camera, d.calibration_object_height_mm)).sizes() +
                        2.0 * kObjectSpareMm * Eigen::Vector2d::Ones();

  const Eigen::Vector2d seen = VisibleRectangle(camera, 0.0).sizes();
  const double length = std::max(5.0, 5.0 * std::floor(0.2 * kLineShare * seen.y()));
  Targets targets;
  targets.sheets = {ChessboardTarget(d.name, d.board), FirstEstimatesTarget(d.name, plan.lines, length),
                    PlanTarget(d.name, plan)};
  const double mm_per_px = seen.x() / camera.width;
  const double merge_mm = FirstEstimatesOptions{}.lines.merge_px * mm_per_px;
  for (std::size_t i = 0; i < plan.lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(plan.lines[i].x_mm - plan.lines[j].x_mm) > merge_mm) continue;
      targets.warnings.push_back("the lines of lasers " + std::to_string(j) + " and " + std::to_string(i) +
                                 " are so close that calibration takes them for one");
    }
  }
  return targets;
}

struct LaidOut {
  PrintedSheet sheet;
  SheetLayout layout;
};

Result<std::string> Pdf(const std::string& title, const std::vector<LaidOut>& sheets) {
  PrintedDocument document(title);
  for (const LaidOut& laid : sheets) DrawSheet(laid.sheet, laid.layout, &document);
  return document.Finish();
}

bool IsPdfName(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".pdf";
}

Status WritePdfs(const std::string& device, const std::vector<LaidOut>& sheets,
                 const std::filesystem::path& out, const Context& context, BoardReport* report) {
  const std::string title = "Dorsum targets for " + device;
  if (IsPdfName(out)) {
    DORSUM_ASSIGN_OR_RETURN(const std::string bytes, Pdf(title, sheets));
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    report->files.push_back(out.string());
    return WriteFile(out, bytes);
  }
  DORSUM_ASSIGN_OR_RETURN(StagedFolder folder, StagedFolder::Create(out));
  for (const LaidOut& laid : sheets) {
    const std::string name = laid.sheet.name + ".pdf";
    DORSUM_ASSIGN_OR_RETURN(const std::string bytes, Pdf(title, {laid}));
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    DORSUM_RETURN_IF_ERROR(WriteFile(folder.path() / name, bytes));
    report->files.push_back((out / name).string());
  }
  return folder.Commit();
}

}  // namespace

Result<BoardReport> PrintBoards(const BoardOptions& options, const std::filesystem::path& out,
                                const Context& context) {
  DeviceDescription device = DefaultDevice();
  if (!options.device_path.empty()) {
    DORSUM_ASSIGN_OR_RETURN(device, ReadDeviceDescription(options.device_path));
  }
  DORSUM_ASSIGN_OR_RETURN(Targets targets, MakeTargets(device));
  BoardReport report;
  report.warnings = targets.warnings;
  std::vector<LaidOut> sheets;
  for (PrintedSheet& sheet : targets.sheets) {
    const auto& wanted = options.sheets;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), sheet.name) == wanted.end()) continue;
    if (options.tile_chessboard) sheet.may_tile = true;
    const Result<SheetLayout> layout = LayOutSheet(sheet, options.paper);
    if (!layout.ok()) {
      return BadInput(layout.error().message + (sheet.may_tile
                                                    ? ", or leave it out with --sheets"
                                                    : ", or on several pages with --tile-chessboard"));
    }
    report.sheets.push_back({sheet.name, layout->Pages(), sheet.size_mm.x(), sheet.size_mm.y()});
    sheets.push_back({std::move(sheet), *layout});
  }
  if (sheets.empty()) return UsageError("there is no such sheet; give chessboard, first-estimates or plan");
  DORSUM_RETURN_IF_ERROR(WritePdfs(device.name, sheets, out, context, &report));
  return report;
}

Json BoardReportToJson(const BoardReport& report) {
  Json sheets = Json::array();
  for (const BoardReport::Sheet& sheet : report.sheets) {
    sheets.push_back(
        {{"name", sheet.name}, {"pages", sheet.pages}, {"size_mm", {sheet.width_mm, sheet.height_mm}}});
  }
  return {{"files", report.files}, {"sheets", sheets}, {"warnings", report.warnings}};
}

}  // namespace dorsum
