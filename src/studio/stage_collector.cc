// SPDX-License-Identifier: Apache-2.0
#include "studio/stage_collector.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "report/colours.h"
#include "report/height_picture.h"
#include "report/photo_pictures.h"
#include "report/plot.h"

namespace dorsum {
namespace {

struct ChainRun {
  ChainStages stages;
  std::optional<Reconstruction> surface;
};

Result<ChainRun> RunChain(const Scan& scan, ReconstructOptions options, const std::string& method,
                          Context context, double begin, double end) {
  ChainRun run;
  StageCollector collector;
  context.sink = &collector;
  const auto outer = context.progress;
  if (outer) {
    context.progress = [&](std::string_view stage, double share) {
      outer(stage, begin + (end - begin) * share);
    };
  }
  options.method = method;
  const auto start = std::chrono::steady_clock::now();
  Result<Reconstruction> surface = Reconstruct(scan.capture, *scan.calibration, options, context);
  run.stages.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.stages.pictures = collector.Take();
  if (surface.ok()) {
    run.stages.points = surface->points.size();
    run.stages.faces = surface->mesh.faces.size();
    run.surface = std::move(surface).value();
  } else if (surface.error().code == ErrorCode::kCancelled) {
    return surface.error();
  } else {
    run.stages.error = surface.error();
  }
  return run;
}

// Of the points of both, without the outermost hundredths.
Range HeightRange(const ChainRun& one, const ChainRun& other) {
  std::vector<double> heights;
  for (const ChainRun* run : {&one, &other}) {
    if (!run->surface) continue;
    for (const SurfacePoint& p : run->surface->points) heights.push_back(p.position.z());
  }
  if (heights.empty()) return {};
  const auto at = [&](double share) {
    const auto middle =
        heights.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), middle, heights.end());
    return *middle;
  };
  const Range range{at(0.01), at(0.99)};
  return range.Span() > 0.1 ? range : Range{range.low - 0.05, range.low + 0.05};
}

// The points of one laser over the dimmed photo.
cv::Mat DrawPoints(const cv::Mat& photo, const SurfacePoints& points, int laser, const Range& range) {
  cv::Mat picture = BrightenPhoto(photo);
  picture *= 0.35;
  const int radius = std::max(1, photo.cols / 900);
  for (const SurfacePoint& p : points) {
    if (p.laser != laser) continue;
    const Colour colour = SequentialColour(range.Share(p.position.z()));
    cv::circle(picture, {cvRound(p.u), cvRound(p.v)}, radius, Pen(colour), cv::FILLED);
  }
  return picture;
}

// What was found of the stripes in the picture of their laser, before anything is said about orders: red
// beside the green of the light.
cv::Mat DrawStripePoints(const cv::Mat& photo, const std::vector<StripePoint>& points) {
  cv::Mat picture = BrightenPhoto(photo);
  picture *= 0.6;
  const int radius = photo.cols / 1800;
  for (const StripePoint& p : points)
    cv::circle(picture, {cvRound(p.u), cvRound(p.v)}, radius, {40, 60, 255}, cv::FILLED);
  return picture;
}

void DrawResult(const Scan& scan, const Range& range, ChainRun* run) {
  if (!run->surface) return;
  const cv::Mat& photo = scan.capture.hand;
  auto& pictures = run->stages.pictures;
  for (const LaserStripes& stripes : run->surface->stripes.lasers) {
    const std::string laser = std::to_string(stripes.laser);
    const auto index = static_cast<std::size_t>(stripes.laser);
    if (index < scan.capture.stripes.size() && scan.capture.stripes[index])
      pictures["stripes/" + laser + "/points"] =
          DrawStripePoints(*scan.capture.stripes[index], stripes.points);
    pictures["orders/" + laser] =
        DrawIndexedStripes(photo, stripes, {.width_px = std::clamp(photo.cols, 1200, 4000)});
    pictures["points/" + laser] = DrawPoints(photo, run->surface->points, stripes.laser, range);
  }
  if (!run->surface->height_field.z.empty())
    pictures["heights"] = DrawHeightMap(run->surface->height_field, {.range_mm = range});
}

// Place in the chain: the mask's stages as they follow each other, then each laser's, then the results.
std::pair<std::size_t, std::string> Place(const std::string& key) {
  static constexpr const char* kOrder[] = {
      "mask/difference", "mask/threshold", "mask/coarse", "mask/mask", "mask/without_shadow",
      "mask/",           "stripes/",       "orders/",     "points/",   "heights"};
  std::size_t place = 0;
  for (const char* start : kOrder) {
    if (key.rfind(start, 0) == 0) break;
    ++place;
  }
  return {place, key};
}

bool Same(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  return a.empty() || cv::norm(a, b, cv::NORM_INF) == 0.0;
}

void FindChanges(const ChainStages& before, const ChainStages& now, std::set<std::string>* changed) {
  for (const auto& [key, picture] : now.pictures) {
    const auto it = before.pictures.find(key);
    if (it == before.pictures.end() || !Same(it->second, picture)) changed->insert(key);
  }
  for (const auto& [key, picture] : before.pictures) {
    if (!now.pictures.contains(key)) changed->insert(key);
  }
}

}  // namespace

void StageCollector::Image(const std::string& key, const cv::Mat& image) {
  if (image.empty()) return;
  cv::Mat kept;
  if (image.depth() == CV_8U) {
    kept = image.clone();
  } else {
    cv::normalize(image, kept, 0.0, 255.0, cv::NORM_MINMAX, CV_8U);
  }
  images_[key] = kept;
}

Result<std::shared_ptr<const StageComparison>> CompareStages(const Scan& scan,
                                                             const ReconstructOptions& options,
                                                             const StageComparison* before,
                                                             const Context& context) {
  if (scan.capture.hand.empty() || !scan.calibration) {
    return BadInput("stages are shown of a capture with its calibration; take one, or open its folder");
  }
  DORSUM_ASSIGN_OR_RETURN(ChainRun classic, RunChain(scan, options, "classic", context, 0.0, 0.45));
  DORSUM_ASSIGN_OR_RETURN(ChainRun ours, RunChain(scan, options, "default", context, 0.45, 0.9));
  const Range range = HeightRange(classic, ours);
  auto comparison = std::make_shared<StageComparison>();
  for (ChainRun* run : {&classic, &ours}) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    DrawResult(scan, range, run);
    for (const auto& [key, picture] : run->stages.pictures) comparison->keys.push_back(key);
  }
  auto& keys = comparison->keys;
  std::sort(keys.begin(), keys.end(),
            [](const std::string& a, const std::string& b) { return Place(a) < Place(b); });
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  comparison->classic = std::move(classic.stages);
  comparison->ours = std::move(ours.stages);
  if (before != nullptr) {
    FindChanges(before->classic, comparison->classic, &comparison->changed);
    FindChanges(before->ours, comparison->ours, &comparison->changed);
  }
  context.Report("pictures", 1.0);
  return std::shared_ptr<const StageComparison>(std::move(comparison));
}

}  // namespace dorsum
