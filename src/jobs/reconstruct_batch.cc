// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_batch.h"

#include <algorithm>
#include <map>
#include <optional>

#include "base/csv.h"
#include "base/files.h"
#include "captures/image_file.h"
#include "captures/names.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/read_ahead.h"
#include "jobs/reconstruct_folder.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

struct BatchSource {
  std::string name;
  fs::path folder, calibration;
};

Result<std::vector<BatchSource>> FindCaptureFolders(const ReconstructRequest& request) {
  const fs::path& dir = request.capture_dir;
  std::error_code ec, ignored;
  std::vector<BatchSource> sources;
  for (const auto& entry : fs::directory_iterator(dir, ec)) {
    if (entry.is_directory(ignored) && FindImage(entry.path(), kBgHandName)) {
      sources.push_back({entry.path().filename().string(), entry.path(), request.calibration_path});
    }
  }
  if (ec) return BadInput("cannot read the folder " + dir.string() + ": " + ec.message());
  if (sources.empty()) return BadInput("no folder in " + dir.string() + " holds an image bgHand");
  std::sort(sources.begin(), sources.end(),
            [](const BatchSource& a, const BatchSource& b) { return a.name < b.name; });
  return sources;
}

// Captures that the campaign counts, each with the calibration that it was stored with unless one is given.
Result<std::vector<BatchSource>> FindCampaignCaptures(const ReconstructRequest& request,
                                                      const Context& context) {
  const fs::path& dir = request.capture_dir;
  std::error_code ec;
  const fs::path from_campaign =
      fs::weakly_canonical(request.out_dir, ec).lexically_relative(fs::weakly_canonical(dir, ec));
  if (!from_campaign.empty() && *from_campaign.begin() != "..") {
    return BadInput("the surfaces of " + request.out_dir.string() +
                    " would lie in the campaign, which holds captures only; name another folder to write to");
  }
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(dir, CampaignLock::Kind::kReader, context));
  DORSUM_ASSIGN_OR_RETURN(const std::vector<CampaignCapture> captures, ListCaptures(dir));
  if (captures.empty()) return BadInput("the campaign " + dir.string() + " has no captures yet");
  std::vector<BatchSource> sources;
  for (const CampaignCapture& c : captures) {
    BatchSource source{c.Name(), c.Folder(dir), request.calibration_path};
    if (source.calibration.empty()) {
      if (c.stored.calibration.empty()) {
        return BadInput(source.folder.string() +
                        " was stored without a calibration; name one with --calibration");
      }
      source.calibration = CalibrationFile(dir, c.stored.calibration);
    }
    sources.push_back(std::move(source));
  }
  return sources;
}

// When a folder last changed: the newest of its files, and of their coming and going.
std::optional<fs::file_time_type> LastChange(const fs::path& dir) {
  std::error_code ec;
  std::optional<fs::file_time_type> newest = fs::last_write_time(dir, ec);
  if (ec) return std::nullopt;
  for (const auto& entry : fs::directory_iterator(dir, ec)) {
    const auto written = entry.last_write_time(ec);
    if (!ec && (!newest || written > *newest)) newest = written;
  }
  return newest;
}

// What an earlier run made of this capture in the same way, if all of it is there.
std::optional<BatchCapture> KeptResult(const ReconstructRequest& request, const Json& recipe) {
  const fs::path report = request.out_dir / kReportJson;
  std::error_code ec;
  const auto made = fs::last_write_time(report, ec);
  const auto captured = LastChange(request.capture_dir);
  if (ec || !captured || *captured > made) return std::nullopt;
  std::vector<std::string> wanted = {"points.ply", "mask.png"};
  for (const std::string& format : request.mesh_formats) wanted.push_back("surface." + format);
  if (request.report) wanted.emplace_back("report.html");
  if (request.stages && !fs::is_directory(request.out_dir / kStageFolder, ec)) return std::nullopt;
  for (const std::string& name : wanted) {
    if (!fs::is_regular_file(request.out_dir / name, ec)) return std::nullopt;
  }
  const auto json = ReadJson(report);
  if (!json.ok() || !json->is_object()) return std::nullopt;
  for (const auto& [key, value] : recipe.items()) {
    if (!json->contains(key) || (*json)[key] != value) return std::nullopt;
  }
  BatchCapture kept;
  kept.outcome = BatchOutcome::kKept;
  const auto count = [&](const char* key) {
    return json->contains(key) && (*json)[key].is_number_unsigned() ? (*json)[key].get<std::size_t>() : 0;
  };
  kept.points = count("points");
  kept.faces = count("triangles");
  return kept;
}

Status WriteTable(const fs::path& path, const BatchSummary& summary) {
  std::string csv = "capture,result,points,triangles,error,warnings\n";
  for (const BatchCapture& c : summary.captures) {
    std::string warnings;
    for (const std::string& w : c.warnings) warnings += (warnings.empty() ? "" : "; ") + w;
    const bool failed = c.outcome == BatchOutcome::kFailed;
    csv += CsvField(c.name) + "," + OutcomeText(c.outcome) + "," + (failed ? "" : std::to_string(c.points)) +
           "," + (failed ? "" : std::to_string(c.faces)) + "," + CsvField(c.error) + "," +
           CsvField(warnings) + "\n";
  }
  return WriteFile(path, csv);
}

BatchCapture Work(const Result<CaptureImages>& images, const ReconstructRequest& request,
                  const LoadedCalibration& calibration, const Context& context) {
  BatchCapture out;
  const auto fail = [&](const Error& error) {
    out.outcome = BatchOutcome::kFailed;
    out.error = error.message;
    return out;
  };
  if (!images.ok()) return fail(images.error());
  const auto summary = ReconstructLoaded(*images, request, calibration, context);
  if (!summary.ok()) return fail(summary.error());
  out.points = summary->points;
  out.faces = summary->faces;
  out.warnings = summary->warnings;
  return out;
}

}  // namespace

const char* OutcomeText(BatchOutcome outcome) {
  switch (outcome) {
    case BatchOutcome::kDone:
      return "done";
    case BatchOutcome::kKept:
      return "kept";
    case BatchOutcome::kFailed:
      return "failed";
  }
  return "";
}

int BatchSummary::Count(BatchOutcome outcome) const {
  return static_cast<int>(std::count_if(captures.begin(), captures.end(),
                                        [&](const BatchCapture& c) { return c.outcome == outcome; }));
}

bool HoldsCampaign(const fs::path& dir) {
  std::error_code ec;
  return fs::is_regular_file(dir / kCampaignJson, ec);
}

Result<BatchSummary> ReconstructBatch(const ReconstructRequest& request, const Context& context) {
  std::map<fs::path, LoadedCalibration> calibrations;  // few, of one device
  const auto load = [&](const fs::path& path) -> Status {
    if (calibrations.contains(path)) return {};
    DORSUM_ASSIGN_OR_RETURN(LoadedCalibration loaded, LoadCalibration(path));
    calibrations.emplace(path, std::move(loaded));
    return {};
  };
  const bool campaign = HoldsCampaign(request.capture_dir);
  if (!campaign) DORSUM_RETURN_IF_ERROR(load(request.calibration_path));
  DORSUM_ASSIGN_OR_RETURN(const std::vector<BatchSource> sources,
                          campaign ? FindCampaignCaptures(request, context) : FindCaptureFolders(request));
  for (const BatchSource& source : sources) DORSUM_RETURN_IF_ERROR(load(source.calibration));
  std::error_code ec;
  if (fs::equivalent(request.capture_dir, request.out_dir, ec)) {
    return BadInput("the surfaces of " + request.out_dir.string() +
                    " would lie among its captures; name another folder to write to");
  }
  fs::create_directories(request.out_dir, ec);
  if (ec) return BadInput("cannot make the folder " + request.out_dir.string() + ": " + ec.message());
  const fs::path table = request.out_dir / kBatchTable;
  DORSUM_RETURN_IF_ERROR(WriteTable(table, {}));  // rather now than after hours

  std::vector<std::optional<BatchCapture>> captures(sources.size());
  std::vector<ReconstructRequest> todo;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    ReconstructRequest one = request;
    one.capture_dir = sources[i].folder;
    one.calibration_path = sources[i].calibration;
    one.out_dir = request.out_dir / sources[i].name;
    captures[i] = KeptResult(one, RecipeOf(one, calibrations.at(sources[i].calibration)));
    if (captures[i]) continue;
    todo.push_back(std::move(one));
    places.push_back(i);
  }
  Context alone = context;  // within one capture
  alone.threads = 1;
  alone.progress = nullptr;
  const Status finished = ReadAhead<Result<CaptureImages>>(
      todo.size(), context,
      [&](std::size_t i) {
        return LoadCapture(todo[i].capture_dir, {}, calibrations.at(todo[i].calibration_path).lasers, alone,
                           StripeChannels(request));
      },
      [&](std::size_t i, const Result<CaptureImages>& images) {
        BatchCapture done = Work(images, todo[i], calibrations.at(todo[i].calibration_path), alone);
        if (!context.IsCancelled() || done.outcome == BatchOutcome::kDone)
          captures[places[i]] = std::move(done);
      });
  BatchSummary summary;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!captures[i]) continue;
    captures[i]->name = sources[i].name;
    summary.captures.push_back(std::move(*captures[i]));
  }
  DORSUM_RETURN_IF_ERROR(WriteTable(table, summary));
  if (finished.ok()) return summary;
  return Error{finished.error().code,
               finished.error().message + " after " + std::to_string(summary.captures.size()) + " of " +
                   std::to_string(sources.size()) + " captures; the same command goes on from there"};
}

}  // namespace dorsum
