// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <Eigen/Geometry>

#include "base/median.h"
#include "base/version.h"

namespace dorsum {
namespace {

std::string Fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// Area of the surface and its highest place, which a person can check by eye.
std::vector<ReportRow> Facts(const Reconstruction& result) {
  double area = 0.0, highest = 0.0;
  for (const auto& f : result.mesh.faces) {
    const Eigen::Vector3d& a = result.mesh.vertices[f[0]];
    area += 0.5 * (result.mesh.vertices[f[1]] - a).cross(result.mesh.vertices[f[2]] - a).norm();
    for (const std::uint32_t i : f) highest = std::max(highest, result.mesh.vertices[i].z());
  }
  std::vector<float> sigmas;
  for (const SurfacePoint& p : result.points) sigmas.push_back(p.sigma);
  return {{"points", std::to_string(result.points.size()), ""},
          {"surface", Fixed(area / 100.0, 1), "cm^2"},
          {"highest place", Fixed(highest, 1), "mm"},
          {"usual uncertainty", Fixed(static_cast<double>(Median(std::move(sigmas))), 2), "mm"}};
}

}  // namespace

ReconstructionReportData CollectReportData(const ReconstructRequest& request, const Reconstruction& result,
                                           const CaptureImages& capture, const ReadyCalibration& ready) {
  ReconstructionReportData data;
  const std::filesystem::path clean = std::filesystem::absolute(request.capture_dir).lexically_normal();
  data.title = (clean.has_filename() ? clean : clean.parent_path()).filename().string();
  data.photo = capture.hand;
  for (const auto& image : capture.stripes) data.stripe_photos.push_back(image.value_or(cv::Mat()));
  data.mask = result.mask.mask;
  data.stripes = result.stripes;
  data.points = result.points;
  data.height_field = result.height_field;
  data.mesh = result.mesh;
  data.facts = Facts(result);
  ReconstructOptions options = request.options;
  const OptionTable table = DescribeReconstructOptions(&options);
  for (const OptionSpec& spec : table.specs()) {
    data.settings.push_back({spec.name, OptionTable::ValueText(spec), ""});
  }
  data.calibration = ready.calibration.parts;
  data.warnings = result.warnings;
  data.version = kVersion;
  return data;
}

}  // namespace dorsum
