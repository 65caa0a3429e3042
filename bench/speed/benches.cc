// SPDX-License-Identifier: Apache-2.0
#include "speed/benches.h"

#include <chrono>

#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>

#include "accuracy/stripe_table.h"
#include "captures/green_channel.h"
#include "speed/allocation_count.h"
#include "speed/floor.h"
#include "speed/point_accuracy.h"
#include "speed/steger.h"

namespace dorsum::speed {
namespace {

Context WithThreads(int threads) {
  Context context;
  context.threads = threads;
  cv::setNumThreads(threads);
  return context;
}

std::vector<cv::Mat> GreenOf(const SpeedScene& scene) {
  std::vector<cv::Mat> green;
  for (const auto& image : scene.capture.stripes) green.push_back(GreenChannel(*image));
  return green;
}

// Steger's detector finds about as many of the stripes as ours with this.
std::vector<cv::Point2f> StegerPoints(const cv::Mat& green) { return DetectSteger(green, 2.4, 0.3); }

void BenchSteger(benchmark::State& state, const SpeedScene& scene, int threads) {
  WithThreads(threads);
  const std::vector<cv::Mat> green = GreenOf(scene);
  for (auto _ : state) {
    for (const cv::Mat& g : green) benchmark::DoNotOptimize(StegerPoints(g).size());
  }
}

// Our detector, which like Steger's is told how wide the lines are and how strong they must be.
struct ReadyDetector {
  cv::Mat green;
  NoiseModel noise;
  RidgeDetectionOptions options;

  std::vector<std::vector<RidgeCandidate>> Find(const Context& context) const {
    return DetectRidges(green, {}, noise, options, context);
  }
};

std::vector<ReadyDetector> DetectorsOf(const SpeedScene& scene, const Context& context) {
  std::vector<ReadyDetector> out;
  for (const cv::Mat& green : GreenOf(scene)) {
    const RidgeSurvey survey = SurveyRidges(green, {}, 0.0, {}, {}, context);
    out.push_back({green, survey.noise, {.width_px = survey.width_px}});
  }
  return out;
}

void BenchDetector(benchmark::State& state, const SpeedScene& scene, int threads) {
  const Context context = WithThreads(threads);
  const std::vector<ReadyDetector> detectors = DetectorsOf(scene, context);
  for (auto _ : state) {
    for (const ReadyDetector& d : detectors) benchmark::DoNotOptimize(d.Find(context).size());
  }
}

void BenchRidges(benchmark::State& state, const SpeedScene& scene, int threads) {
  const Context context = WithThreads(threads);
  const std::vector<cv::Mat> green = GreenOf(scene);
  for (auto _ : state) {
    for (const cv::Mat& g : green) benchmark::DoNotOptimize(FindRidges(g, {}, 0, {}, context).points.size());
  }
}

// A whole reconstruction; its stages' times become counters.
void BenchWhole(benchmark::State& state, const SpeedScene& scene, const std::string& method, int threads) {
  using Clock = std::chrono::steady_clock;
  Context context = WithThreads(threads);
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
  for (const auto& [name, ms] : spent) state.counters[name] = ms / static_cast<double>(state.iterations());
}

// Prints as usual and keeps the medians.
class Collector : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median" || run.error_occurred) continue;
      measured_[run.run_name.function_name] = run.GetAdjustedRealTime();
      for (const auto& [name, counter] : run.counters) {
        measured_[run.run_name.function_name + "/" + name] = counter.value;
      }
    }
    ConsoleReporter::ReportRuns(runs);
  }
  const Measured& measured() const { return measured_; }

 private:
  Measured measured_;
};

template <class Body>
void Add(const std::string& name, const Body& body) {
  benchmark::RegisterBenchmark(name.c_str(), body)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->Repetitions(5)
      ->ReportAggregatesOnly();
}

}  // namespace

Measured RunBenches(const SpeedScene& scene, const std::map<std::string, const SpeedScene*>& sizes) {
  Add("floor", [&](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(SumBytes(scene.images));
  });
  for (const int threads : {1, 2}) {
    const std::string tail = "/threads:" + std::to_string(threads);
    Add("steger" + tail, [&, threads](benchmark::State& s) { BenchSteger(s, scene, threads); });
    Add("detector" + tail, [&, threads](benchmark::State& s) { BenchDetector(s, scene, threads); });
    Add("ridges" + tail, [&, threads](benchmark::State& s) { BenchRidges(s, scene, threads); });
    for (const char* method : {"classic", "default"}) {
      Add(method + tail,
          [&, threads, method](benchmark::State& s) { BenchWhole(s, scene, method, threads); });
    }
  }
  for (const auto& [name, other] : sizes) {
    Add(name, [&other = *other](benchmark::State& s) { BenchWhole(s, other, "default", 2); });
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  return collector.measured();
}

Result<Measured> CompareDetectors(const SpeedScene& scene) {
  const Context context = WithThreads(1);
  DetectorComparison comparison;
  const std::vector<ReadyDetector> detectors = DetectorsOf(scene, context);
  for (std::size_t k = 0; k < detectors.size(); ++k) {
    DORSUM_ASSIGN_OR_RETURN(
        const std::vector<accuracy::TrueStripe> truth,
        accuracy::ReadStripeTable(scene.truth_dir / ("stripes" + std::to_string(k) + ".csv.gz")));
    std::vector<cv::Point2f> ours;
    const auto rows = detectors[k].Find(context);
    for (std::size_t v = 0; v < rows.size(); ++v) {
      for (const RidgeCandidate& c : rows[v]) ours.emplace_back(c.u, static_cast<float>(v));
    }
    comparison.Add(truth, ours, StegerPoints(detectors[k].green));
  }
  Measured out;
  for (const auto& [name, value] : comparison.Summary()) out["points/" + name] = value;
  return out;
}

Measured CountAllocations(const SpeedScene& scene) {
  const Context context = WithThreads(2);
  const auto scan = [&] { return Reconstruct(scene.capture, scene.bundle, {}, context).ok(); };
  for (int i = 0; i < 3; ++i) benchmark::DoNotOptimize(scan());
  const AllocationCount count(scene.capture.hand.total());
  benchmark::DoNotOptimize(scan());
  return {{"allocations", static_cast<double>(count.count())}};
}

}  // namespace dorsum::speed
