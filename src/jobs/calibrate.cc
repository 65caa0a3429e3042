// SPDX-License-Identifier: Apache-2.0
#include "jobs/calibrate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "base/files.h"
#include "base/parallel.h"
#include "base/version.h"
#include "captures/image_file.h"
#include "captures/names.h"
#include "jobs/box_samples.h"
#include "jobs/calibrate_bundle.h"
#include "jobs/reconstruct.h"

namespace dorsum {
namespace {

// The polynomial belongs to the plane model alone: cones go without it.
PartReport ReportCorrection(const std::vector<LaserCorrection>& evidence, bool cones) {
  PartReport report;
  report.part = "surface error correction";
  double worst = 0.0;
  for (const LaserCorrection& e : evidence) {
    const std::string who = "laser " + std::to_string(e.laser);
    report.figures.push_back({who + ": height error before", e.fit.rms_before_mm, "mm"});
    report.figures.push_back({who + ": height error after", e.fit.rms_after_mm, "mm"});
    report.figures.push_back({who + ": points", static_cast<double>(e.fit.samples), ""});
    worst = std::max(worst, e.fit.rms_after_mm);
  }
  if (evidence.empty() && cones) {
    report.verdict = "no boxes were used, so the document's plane sheets stay uncorrected; cones need none";
  } else if (evidence.empty()) {
    report.grade = Grade::kDoubtful;
    report.verdict = "there are no boxes under heights/, so heights stay uncorrected";
  } else if (worst > 3.0) {
    report.grade = Grade::kDoubtful;
    report.verdict =
        "the boxes' heights do not fit well after the correction; are the heights in setup.json right?";
  } else {
    report.verdict = "the second-order correction explains the boxes";
  }
  return report;
}

Status FitCorrections(const CalibrationSeries& series, const CalibrateOptions& options,
                      const Context& context, CalibrationRun* run) {
  Calibration& calibration = run->calibration;
  const bool cones = run->bundle.has_value();
  const bool planes = std::all_of(calibration.device.lasers.begin(), calibration.device.lasers.end(),
                                  [](const LaserGeometry& l) { return !l.planes.empty(); });
  if (!series.box_heights_mm.empty() && planes) {
    SamplesByLaser samples;
    if (cones) {
      samples = SampleBundle(*run->bundle, calibration.device);
    } else {
      DORSUM_ASSIGN_OR_RETURN(const ReadyCalibration ready,
                              PrepareCalibration(calibration, series.dir.string()));
      DORSUM_ASSIGN_OR_RETURN(samples, SampleBoxes(series, ready, options, context, &calibration.warnings));
    }
    for (LaserGeometry& laser : calibration.device.lasers) {
      LaserCorrection evidence;
      evidence.laser = laser.laser;
      evidence.samples = std::move(samples[laser.laser]);
      const Result<CorrectionFit> fit = FitCorrection(evidence.samples);
      if (!fit.ok()) {
        calibration.warnings.push_back("laser " + std::to_string(laser.laser) + ": " + fit.error().message);
        continue;
      }
      evidence.fit = *fit;
      laser.correction = fit->polynomial;
      if (!cones) laser.residual_mm = fit->rms_after_mm;
      run->correction.push_back(std::move(evidence));
    }
  }
  calibration.parts.push_back(ReportCorrection(run->correction, cones));
  return {};
}

Result<std::string> MakeReport(const CalibrationSeries& series, const CalibrationRun& run) {
  CalibrationReportData data;
  const std::filesystem::path clean = std::filesystem::absolute(series.dir).lexically_normal();
  data.title = "Calibration from " + (clean.has_filename() ? clean : clean.parent_path()).filename().string();
  data.method = run.calibration.method;
  data.classic = run.classic;
  if (run.bundle) data.residuals = run.bundle->residuals;
  data.correction = run.correction;
  data.parts = run.calibration.parts;
  data.warnings = run.calibration.warnings;
  data.sources = run.calibration.sources.size();
  data.board_inner = {series.setup.board_columns, series.setup.board_rows};
  data.square_mm = series.setup.square_mm;
  data.version = run.calibration.version;
  DORSUM_ASSIGN_OR_RETURN(data.board_photo, series.Read(ChessName(0)));
  data.background_photos.resize(static_cast<std::size_t>(series.lasers.back()) + 1);
  for (const int laser : series.lasers) {
    DORSUM_ASSIGN_OR_RETURN(data.background_photos[static_cast<std::size_t>(laser)],
                            series.Read(StripesBgName(laser)));
  }
  return MakeCalibrationReport(data);
}

Status CalibrateByDocument(const CalibrationSeries& series, const CalibrateOptions& options,
                           const Context& context, CalibrationRun* run) {
  DORSUM_ASSIGN_OR_RETURN(run->classic, CalibrateClassic(series, options.classic, context));
  Calibration& c = run->calibration;
  c.device = run->classic.device;
  c.warnings.insert(c.warnings.end(), run->classic.warnings.begin(), run->classic.warnings.end());
  c.parts.push_back(run->classic.camera.report);
  for (const LaserCalibration& laser : run->classic.lasers) c.parts.push_back(laser.report);
  return {};
}

// What the calibration was made from.
Result<std::vector<SourceFile>> HashFiles(const CalibrationSeries& series, const Context& context) {
  const std::vector<std::filesystem::path> files = series.Files();
  std::vector<SourceFile> sources(files.size());
  std::vector<Status> status(files.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(files.size()), [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    const Result<std::string> bytes = ReadFile(series.dir / files[k]);
    if (bytes.ok()) {
      sources[k] = {files[k].generic_string(), Sha256Hex(*bytes)};
    } else {
      status[k] = bytes.error();
    }
  });
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  return sources;
}

// Says at once, and not after all the work, that there is nowhere to write.
Status CheckTarget(const std::filesystem::path& out) {
  std::error_code ec;
  if (!out.has_filename() || std::filesystem::is_directory(out, ec)) {
    return BadInput("cannot write " + out.string() + ": it is a folder; name a file in it");
  }
  if (out.extension() == ".html") {
    return BadInput("cannot write the calibration to " + out.string() +
                    ": its report takes that name; name a .json file");
  }
  const std::filesystem::path folder = out.has_parent_path() ? out.parent_path() : ".";
  if (std::filesystem::is_directory(folder, ec)) return {};
  return BadInput("cannot write " + out.string() + ": there is no folder " + folder.string() +
                  "; make it, or choose another");
}

}  // namespace

Result<CalibrationRun> CalibrateSeries(const CalibrationSeries& series, const CalibrateOptions& options,
                                       const Context& context) {
  const CalibrationSeries kept = series.KeepingPictures();
  CalibrationRun run;
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat background, kept.Read(kBgNoHandName));
  DORSUM_RETURN_IF_ERROR(CheckExposure(background, (kept.dir / kBgNoHandName).string()));
  Calibration& c = run.calibration;
  c.method = options.method;
  c.version = kVersion;
  c.warnings = kept.warnings;
  if (options.method == "classic") {
    DORSUM_RETURN_IF_ERROR(CalibrateByDocument(kept, options, context, &run));
  } else {
    DORSUM_RETURN_IF_ERROR(CalibrateByBundle(kept, options, context, &run));
  }
  DORSUM_ASSIGN_OR_RETURN(const auto background_path, RequireImage(kept.dir, kBgNoHandName));
  DORSUM_ASSIGN_OR_RETURN(c.background, ReadFile(background_path));
  DORSUM_RETURN_IF_ERROR(FitCorrections(kept, options, context, &run));
  DORSUM_ASSIGN_OR_RETURN(c.sources, HashFiles(kept, context));
  return run;
}

Result<CalibrationRun> CalibrateFolder(const std::filesystem::path& dir, const std::filesystem::path& out,
                                       const CalibrateOptions& options, const Context& context) {
  DORSUM_RETURN_IF_ERROR(CheckTarget(out));
  DORSUM_ASSIGN_OR_RETURN(const CalibrationSeries series, LoadCalibrationSeries(dir));
  DORSUM_ASSIGN_OR_RETURN(CalibrationRun run, CalibrateSeries(series, options, context));
  context.Report("report", 0.95);
  DORSUM_ASSIGN_OR_RETURN(const std::string html, MakeReport(series, run));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  std::filesystem::path page = out;
  page.replace_extension(".html");
  DORSUM_RETURN_IF_ERROR(WriteFile(page, html));
  if (const Status written = WriteCalibration(out, run.calibration); !written.ok()) {
    std::error_code ignored;
    std::filesystem::remove(page, ignored);
    return written.error();
  }
  run.files = {out.string(), page.string()};
  return run;
}

}  // namespace dorsum
