// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>

#include "captures/image_file.h"
#include "speed/floor.h"
#include "speed/scene.h"
#include "speed/steger.h"

namespace dorsum::speed {
namespace {

void BenchFloor(benchmark::State& state, const SpeedScene& scene) {
  for (auto _ : state) benchmark::DoNotOptimize(SumBytes(scene.images));
}

void BenchSteger(benchmark::State& state, const SpeedScene& scene, int threads) {
  cv::setNumThreads(threads);
  std::vector<cv::Mat> green;
  for (const auto& image : scene.capture.stripes) green.push_back(GreenChannel(*image));
  for (auto _ : state) {
    for (const cv::Mat& g : green) benchmark::DoNotOptimize(DetectSteger(g, 2.4, 1.0).size());
  }
}

void BenchRidges(benchmark::State& state, const SpeedScene& scene, int threads) {
  Context context;
  context.threads = threads;
  cv::setNumThreads(threads);
  std::vector<cv::Mat> green;
  for (const auto& image : scene.capture.stripes) green.push_back(GreenChannel(*image));
  for (auto _ : state) {
    for (const cv::Mat& g : green) benchmark::DoNotOptimize(FindRidges(g, {}, 0, {}, context).points.size());
  }
}

void BenchWhole(benchmark::State& state, const SpeedScene& scene, const std::string& method, int threads) {
  cv::setNumThreads(threads);
  Context context;
  context.threads = threads;
  using Clock = std::chrono::steady_clock;
  std::map<std::string, double> spent;
  std::string stage;
  Clock::time_point since;
  const auto turn = [&](const std::string& next) {
    const auto now = Clock::now();
    if (!stage.empty()) spent[stage] += std::chrono::duration<double, std::milli>(now - since).count();
    stage = next;
    since = now;
  };
  context.progress = [&](std::string_view name, double) { turn(std::string(name)); };
  ReconstructOptions options;
  options.method = method;
  const ReadyCalibration& ready = method == "classic" ? scene.classic : scene.bundle;
  for (auto _ : state) {
    const auto result = Reconstruct(scene.capture, ready, options, context);
    turn("");
    if (!result.ok()) state.SkipWithError(result.error().message.c_str());
  }
  for (const auto& [name, ms] : spent) {
    state.counters[name + "_ms"] = ms / static_cast<double>(state.iterations());
  }
}

int Main(int argc, char** argv) {
  std::string cache = "speed-cache";
  CLI::App app("How fast the product is, as ratios of times in one run");
  app.add_option("--cache", cache, "folder for rendered devices");
  app.allow_extras();
  CLI11_PARSE(app, argc, argv);
  const auto made = MakeSpeedScene({}, cache, Context{});
  if (!made.ok()) {
    std::fprintf(stderr, "speed: error: %s\n", made.error().message.c_str());
    return 1;
  }
  const SpeedScene& scene = *made;
  const auto add = [](const std::string& name, auto body) {
    benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  add("floor", [&](benchmark::State& s) { BenchFloor(s, scene); });
  for (const int threads : {1, 2}) {
    const std::string tail = "/threads:" + std::to_string(threads);
    add("steger" + tail, [&, threads](benchmark::State& s) { BenchSteger(s, scene, threads); });
    add("ridges" + tail, [&, threads](benchmark::State& s) { BenchRidges(s, scene, threads); });
    for (const char* method : {"classic", "default"}) {
      add(method + tail,
          [&, threads, method](benchmark::State& s) { BenchWhole(s, scene, method, threads); });
    }
  }
  std::vector<std::string> rest = app.remaining();
  std::vector<char*> args = {argv[0]};
  for (std::string& r : rest) args.push_back(r.data());
  int count = static_cast<int>(args.size());
  benchmark::Initialize(&count, args.data());
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace dorsum::speed

int main(int argc, char** argv) {
  try {
    return dorsum::speed::Main(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed: internal error: %s\n", error.what());
    return 3;
  }
}
