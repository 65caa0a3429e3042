// SPDX-License-Identifier: Apache-2.0
#include "jobs/find_stripes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "base/csv.h"
#include "base/files.h"
#include "base/median.h"
#include "captures/green_channel.h"
#include "captures/image_file.h"

namespace dorsum {
namespace {

void AppendLines(const LaserStripes& stripes, const std::string& lead, std::string* csv) {
  std::array<char, 160> line{};
  std::vector<StripePoint> points = stripes.points;
  std::stable_sort(points.begin(), points.end(), [](const StripePoint& p, const StripePoint& q) {
    return p.v < q.v || (p.v == q.v && p.u < q.u);
  });
  for (const StripePoint& p : points) {
    std::snprintf(line.data(), line.size(), "%d,%.4f,%.4f,%.1f,%.3f,%d\n", static_cast<int>(p.v),
                  static_cast<double>(p.u), static_cast<double>(p.sd_px), static_cast<double>(p.peak),
                  static_cast<double>(p.width), p.segment);
    *csv += lead;
    *csv += line.data();
  }
}

FoundStripes Summarise(const LaserStripes& stripes, std::string image) {
  FoundStripes found;
  found.image = std::move(image);
  found.points = stripes.points.size();
  found.segments = stripes.segments.size();
  std::vector<float> widths, sds;
  for (const StripePoint& p : stripes.points) {
    widths.push_back(p.width);
    sds.push_back(p.sd_px);
  }
  found.median_width_px = Median(std::move(widths));
  found.median_sd_px = Median(std::move(sds));
  return found;
}

}  // namespace

Result<std::vector<FoundStripes>> FindStripes(const FindStripesRequest& request, const Context& context) {
  const bool several = request.images.size() > 1;
  std::string csv =
      several ? "image,row,column,sd,peak,width,segment\n" : "row,column,sd,peak,width,segment\n";
  std::vector<FoundStripes> found;
  for (std::size_t i = 0; i < request.images.size(); ++i) {
    const std::string name = request.images[i].string();
    context.Report("stripes", static_cast<double>(i) / static_cast<double>(request.images.size()));
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    DORSUM_ASSIGN_OR_RETURN(const cv::Mat image, ReadImage(request.images[i]));
    RidgeOptions ridges = request.ridges;
    ridges.scale_deviations = !request.pool;
    LaserStripes stripes = FindRidges(GreenChannel(image), cv::Mat(), 0, ridges, context);
    if (request.pool) stripes = PoolAlongStripes(std::move(stripes), request.pooling, context);
    AppendLines(stripes, several ? CsvField(name) + "," : "", &csv);
    found.push_back(Summarise(stripes, name));
  }
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  DORSUM_RETURN_IF_ERROR(WriteFile(request.out_csv, csv));
  return found;
}

Json FoundStripesToJson(const std::vector<FoundStripes>& found) {
  Json images = Json::array();
  for (const FoundStripes& f : found) {
    images.push_back({{"image", f.image},
                      {"points", f.points},
                      {"segments", f.segments},
                      {"median_width_px", f.median_width_px},
                      {"median_sd_px", f.median_sd_px}});
  }
  return {{"schema", "dorsum/stripes"}, {"version", 1}, {"images", std::move(images)}};
}

std::string FoundStripesToText(const std::vector<FoundStripes>& found) {
  std::string text;
  std::array<char, 200> line{};
  for (const FoundStripes& f : found) {
    std::snprintf(line.data(), line.size(),
                  "%zu points in %zu segments, width %.2f px, sd %.3f px: ", f.points, f.segments,
                  f.median_width_px, f.median_sd_px);
    text += line.data() + f.image + "\n";
  }
  return text;
}

}  // namespace dorsum
