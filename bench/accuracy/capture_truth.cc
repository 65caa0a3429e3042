// SPDX-License-Identifier: Apache-2.0
#include "accuracy/capture_truth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <opencv2/imgcodecs.hpp>

#include "accuracy/stripe_table.h"
#include "base/json.h"

namespace dorsum::accuracy {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kHeightStepMm = 0.002;
constexpr int kMostLasers = 8;

Result<cv::Mat> ReadTruthImage(const std::filesystem::path& path, int type) {
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  if (image.empty()) return BadInput(path.string() + " is missing or no image");
  if (image.channels() > 1) cv::extractChannel(image, image, 0);
  if (image.type() != type) return BadInput(path.string() + " has another depth than truth has");
  return image;
}

// World position of every pixel whose height code is set: its ray at that height.
cv::Mat3d Positions(const cv::Mat1w& codes, const Camera& camera) {
  cv::Mat3d xyz(codes.size());
  const Eigen::Vector3d centre = camera.Center();
  for (int v = 0; v < codes.rows; ++v) {
    for (int u = 0; u < codes.cols; ++u) {
      const int code = codes(v, u);
      xyz(v, u) = cv::Vec3d(kNan, kNan, kNan);
      if (code == 0) continue;
      const double z = (code - 1) * kHeightStepMm;
      const Eigen::Vector3d d = CastRay(camera, {static_cast<double>(u), static_cast<double>(v)}).direction;
      const Eigen::Vector3d p = centre + (z - centre.z()) / d.z() * d;
      xyz(v, u) = cv::Vec3d(p.x(), p.y(), p.z());
    }
  }
  return xyz;
}

}  // namespace

Result<Camera> ReadTrueCamera(const std::filesystem::path& device_json) {
  DORSUM_ASSIGN_OR_RETURN(const Json device, ReadJson(device_json));
  JsonReader top(device, device_json.string());
  JsonReader json(top.Object("camera"), device_json.string() + ": camera");
  Camera camera;
  camera.width = json.Integer("width", 1, 100000);
  camera.height = json.Integer("height", 1, 100000);
  const std::vector<double> distortion = json.Numbers("dist"), t = json.Numbers("t", 3);
  const Json& k = json.Array("K", 3);
  const Json& r = json.Array("R", 3);
  DORSUM_RETURN_IF_ERROR(top.status());
  DORSUM_RETURN_IF_ERROR(json.status());
  if (distortion.size() > camera.distortion.size()) {
    return BadInput(device_json.string() + ": camera: dist has more than five coefficients");
  }
  try {
    camera.fx = k.at(0).at(0).get<double>();
    camera.fy = k.at(1).at(1).get<double>();
    camera.cx = k.at(0).at(2).get<double>();
    camera.cy = k.at(1).at(2).get<double>();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        camera.camera_from_world.rotation(i, j) =
            r.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j)).get<double>();
      }
    }
  } catch (const Json::exception& e) {
    return BadInput(device_json.string() + ": camera: " + e.what());
  }
  std::copy(distortion.begin(), distortion.end(), camera.distortion.begin());
  camera.camera_from_world.translation = Eigen::Vector3d(t[0], t[1], t[2]);
  return camera;
}

Result<CaptureTruth> ReadCaptureTruth(const std::filesystem::path& truth_dir,
                                      const std::filesystem::path& device_json) {
  CaptureTruth truth;
  DORSUM_ASSIGN_OR_RETURN(truth.camera, ReadTrueCamera(device_json));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat codes, ReadTruthImage(truth_dir / "height.png", CV_16UC1));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat material, ReadTruthImage(truth_dir / "material.png", CV_8UC1));
  if (codes.size() != material.size()) return BadInput(truth_dir.string() + ": images of two sizes");
  truth.material = material;
  truth.xyz = Positions(codes, truth.camera);
  for (int laser = 0; laser < kMostLasers; ++laser) {
    std::filesystem::path table = truth_dir / ("stripes" + std::to_string(laser) + ".csv");
    if (!std::filesystem::exists(table)) table += ".gz";
    if (!std::filesystem::exists(table)) continue;
    DORSUM_ASSIGN_OR_RETURN(std::vector<TrueStripe> stripes, ReadStripeTable(table));
    std::stable_sort(stripes.begin(), stripes.end(), [](const TrueStripe& a, const TrueStripe& b) {
      return std::tie(a.row, a.u) < std::tie(b.row, b.u);
    });
    truth.lasers[laser] = std::move(stripes);
  }
  return truth;
}

cv::Vec3d TruthAt(const CaptureTruth& truth, double u, double v, double max_step_mm) {
  const cv::Vec3d nothing(kNan, kNan, kNan);
  const double u0 = std::floor(u), v0 = std::floor(v);
  const bool inside = u0 >= 0.0 && v0 >= 0.0 && u0 < truth.material.cols - 1 && v0 < truth.material.rows - 1;
  if (!inside) return nothing;
  const int c = static_cast<int>(u0), r = static_cast<int>(v0);
  const int material = truth.material(r, c);
  if (!CaptureTruth::IsObject(material)) return nothing;
  const cv::Vec3d p[4] = {truth.xyz(r, c), truth.xyz(r, c + 1), truth.xyz(r + 1, c), truth.xyz(r + 1, c + 1)};
  double low = p[0][2], high = p[0][2];
  for (int i = 0; i < 4; ++i) {
    if (truth.material(r + i / 2, c + i % 2) != material || std::isnan(p[i][2])) return nothing;
    low = std::min(low, p[i][2]);
    high = std::max(high, p[i][2]);
  }
  if (!(high - low < max_step_mm)) return nothing;
  const double du = u - u0, dv = v - v0;
  return (p[0] * (1.0 - du) + p[1] * du) * (1.0 - dv) + (p[2] * (1.0 - du) + p[3] * du) * dv;
}

}  // namespace dorsum::accuracy
