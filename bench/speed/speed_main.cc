// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include "accuracy/document.h"
#include "base/files.h"
#include "base/heap.h"
#include "captures/picture_pool.h"
#include "cli/session.h"
#include "speed/benches.h"

namespace dorsum::speed {
namespace {

namespace fs = std::filesystem;

const fs::path kBench = fs::path(DORSUM_SOURCE_DIR) / "bench/speed";
constexpr const char* kRecord = "speed.json";

struct Arguments {
  std::string cache, results, write, check;
  int batch = 200;
  bool brief = false, no_sizes = false;
};

Result<Measured> Measure(const Arguments& arguments, const Context& context) {
  const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
  DORSUM_ASSIGN_OR_RETURN(const SpeedScene scene, MakeSpeedScene({}, arguments.cache, context));
  Measured all;
  if (!arguments.brief) {  // first: a child's peak of memory begins at that of the process that starts it
    DORSUM_ASSIGN_OR_RETURN(all, TimeProcesses(scene, bin / "dorsum", bin / "speed_imread", arguments.batch,
                                               fs::path(arguments.cache) / "batch"));
  }
  std::map<std::string, SpeedScene> others;
  const auto add = [&](const std::string& name, const SpeedDevice& device) -> Status {
    if (arguments.brief || arguments.no_sizes) return {};
    std::fprintf(stderr, "%s\n", name.c_str());
    DORSUM_ASSIGN_OR_RETURN(others[name], MakeSpeedScene(device, arguments.cache, context));
    return {};
  };
  char name[64];
  for (const double megapixels : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    std::snprintf(name, sizeof name, "size/megapixels:%.1f", megapixels);
    DORSUM_RETURN_IF_ERROR(add(name, {.megapixels = megapixels}));
  }
  for (const int lasers : {1, 2, 8}) {
    std::snprintf(name, sizeof name, "size/lasers:%d", lasers);
    DORSUM_RETURN_IF_ERROR(add(name, {.lasers = lasers}));
  }
  std::map<std::string, const SpeedScene*> sizes;
  for (const auto& [size, other] : others) sizes[size] = &other;
  all.merge(RunBenches(scene, sizes));
  all.merge(CountAllocations(scene));
  DORSUM_ASSIGN_OR_RETURN(Measured points, CompareDetectors(scene));
  all.merge(points);
  if (arguments.brief) return all;
  DORSUM_ASSIGN_OR_RETURN(Measured calibration, TimeCalibration(scene));
  all.merge(calibration);
  return all;
}

Result<std::string> MakeDocument(const Measured& measured) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(kBench / "performance.md.in"));
  return accuracy::FillTemplate(text, {{"figures", FigureTable(measured)},
                                       {"detectors", DetectorTable(measured)},
                                       {"stages", StageTable(measured)},
                                       {"sizes", SizeTable(measured)}});
}

Status RunAll(const Arguments& arguments, const Context& context) {
  if (!arguments.check.empty()) {
    const fs::path record = kBench / "results" / kRecord;
    DORSUM_ASSIGN_OR_RETURN(const Json json, ReadJson(record));
    DORSUM_ASSIGN_OR_RETURN(const Measured recorded, MeasuredFromJson(json, record.string()));
    DORSUM_ASSIGN_OR_RETURN(const std::string text, MakeDocument(recorded));
    DORSUM_ASSIGN_OR_RETURN(const std::string there, ReadFile(arguments.check));
    if (there == text) return {};
    return Error{ErrorCode::kAnswerIsNo,
                 arguments.check + " is not what its template and results give; write it anew"};
  }
  DORSUM_ASSIGN_OR_RETURN(const Measured measured, Measure(arguments, context));
  std::printf("\n%s\n%s\n%s\n%s", FigureTable(measured).c_str(), DetectorTable(measured).c_str(),
              StageTable(measured).c_str(), SizeTable(measured).c_str());
  if (!arguments.results.empty()) {
    fs::create_directories(arguments.results);
    DORSUM_RETURN_IF_ERROR(WriteJson(fs::path(arguments.results) / kRecord, MeasuredToJson(measured)));
  }
  if (arguments.write.empty()) return {};
  DORSUM_ASSIGN_OR_RETURN(const std::string text, MakeDocument(measured));
  return WriteFile(arguments.write, text);
}

int Run(int argc, char** argv) {
  Session session;
  Arguments arguments;
  arguments.cache = (fs::temp_directory_path() / "dorsum-speed").string();
  CLI::App app("How fast the product is: ratios of times in one run, on two processors.");
  app.add_option("--cache", arguments.cache, "folder that keeps rendered devices")->capture_default_str();
  app.add_option("--results", arguments.results, "folder to record the times in (bench/speed/results)");
  app.add_option("--write", arguments.write, "write the document (docs/performance.md)");
  app.add_option("--check", arguments.check, "fail unless this document is what the recorded times give");
  app.add_option("--batch", arguments.batch, "captures of the batch")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_flag("--no-sizes", arguments.no_sizes, "leave other pictures and numbers of lasers out");
  app.add_flag("--short", arguments.brief, "one device, and nothing that runs for minutes");
  app.allow_extras();
  app.footer(
      "Other arguments go to Google Benchmark, such as --benchmark_filter=floor.\n"
      "Example: speed --results bench/speed/results --write docs/performance.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : ExitCode(ErrorCode::kUsage);
  }
  std::vector<std::string> rest = app.remaining();
  rest.insert(rest.begin(), argv[0]);
  rest.emplace_back("--benchmark_enable_random_interleaving=true");
  std::vector<char*> others;
  for (std::string& r : rest) others.push_back(r.data());
  int count = static_cast<int>(others.size());
  benchmark::Initialize(&count, others.data());
  if (benchmark::ReportUnrecognizedArguments(count, others.data())) return ExitCode(ErrorCode::kUsage);
  Context context = session.MakeContext();
  context.progress = nullptr;
  if (const Status done = RunAll(arguments, context); !done.ok()) session.Fail(done.error());
  return session.Finish();
}

}  // namespace
}  // namespace dorsum::speed

int main(int argc, char** argv) {
  dorsum::KeepFreedMemory();  // as the products do
  dorsum::KeepPictureMemory();
  dorsum::CatchInterrupts();
  try {
    return dorsum::speed::Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed: internal error: %s\n", error.what());
    return 5;
  }
}
