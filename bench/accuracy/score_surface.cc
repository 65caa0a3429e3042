// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "accuracy/object_area.h"
#include "accuracy/score.h"

namespace dorsum::accuracy {
namespace {

constexpr double kWrongMm = 2.0;
constexpr double kSurfaceStepMm = 0.5;  // true heights around a place differ by less
constexpr double kFlatMm = 1.0;         // true heights of a pixel and its neighbours differ by less

// Where the mesh is seen.
cv::Mat1b Cover(const CaptureTruth& truth, const TriangleMesh& mesh,
                const std::vector<Eigen::Vector2d>& pixels) {
  constexpr int kFractionBits = 4;
  cv::Mat1b cover = cv::Mat1b::zeros(truth.material.size());
  for (const auto& face : mesh.faces) {
    std::array<cv::Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d& p = pixels[face[i]];
      corners[i] = {static_cast<int>(std::nearbyint(p.x() * (1 << kFractionBits))),
                    static_cast<int>(std::nearbyint(p.y() * (1 << kFractionBits)))};
    }
    cv::fillConvexPoly(cover, corners.data(), 3, cv::Scalar(1), cv::LINE_8, kFractionBits);
    // Of a triangle smaller than a pixel it draws nothing.
    const cv::Rect box = cv::boundingRect(corners);
    const cv::Point middle((box.x + box.width / 2) >> kFractionBits,
                           (box.y + box.height / 2) >> kFractionBits);
    const bool small = std::max(box.width, box.height) < (2 << kFractionBits);
    if (small && cv::Rect({}, cover.size()).contains(middle)) cover(middle) = 1;
  }
  return cover;
}

// Pixels of the object around which its height hardly changes; those on its outline are none.
cv::Mat1b FlatPixels(const CaptureTruth& truth, const cv::Mat1b& object) {
  constexpr float kFar = 1e3F;
  cv::Mat1f high(object.size()), low(object.size());
  for (int v = 0; v < object.rows; ++v) {
    for (int u = 0; u < object.cols; ++u) {
      const auto z = static_cast<float>(truth.xyz(v, u)[2]);
      const bool known = object(v, u) != 0 && !std::isnan(z);
      high(v, u) = known ? z : kFar;
      low(v, u) = known ? z : -kFar;
    }
  }
  const cv::Mat1b square = cv::Mat1b::ones(3, 3);
  cv::dilate(high, high, square);
  cv::erode(low, low, square);
  return (high - low < kFlatMm) & (object > 0);
}

}  // namespace

std::optional<SurfaceScore> ScoreSurface(const CaptureTruth& truth, const TriangleMesh& mesh,
                                         const PlaneAlignment& alignment) {
  constexpr std::size_t kFewest = 50;
  std::vector<Eigen::Vector3d> places;
  places.reserve(mesh.vertices.size() + mesh.faces.size());
  for (const Eigen::Vector3d& p : mesh.vertices) {
    const Eigen::Vector2d xy = alignment.rotation * p.head<2>() + alignment.shift;
    places.emplace_back(xy.x(), xy.y(), p.z());
  }
  for (const auto& f : mesh.faces) places.emplace_back((places[f[0]] + places[f[1]] + places[f[2]]) / 3.0);
  std::vector<Eigen::Vector2d> pixels;
  std::vector<double> errors;
  int wrong = 0;
  for (const Eigen::Vector3d& p : places) {
    pixels.push_back(Project(truth.camera, p));
    const double z = TruthAt(truth, pixels.back().x(), pixels.back().y(), kSurfaceStepMm)[2];
    if (std::isnan(z)) continue;
    errors.push_back(p.z() - z);
    if (std::abs(errors.back()) > kWrongMm) ++wrong;
  }
  if (errors.size() <= kFewest) return std::nullopt;
  SurfaceScore score;
  score.z = Describe(errors);
  score.wrong = static_cast<double>(wrong) / static_cast<double>(errors.size());
  score.faces = static_cast<int>(mesh.faces.size());
  const cv::Mat1b object = ObjectArea(truth, 0), cover = Cover(truth, mesh, pixels);
  const cv::Mat1b flat = FlatPixels(truth, object), far = ObjectArea(truth, 3) == 0;
  score.cover = static_cast<double>(cv::countNonZero(flat & (cover > 0))) / cv::countNonZero(flat);
  score.beyond = static_cast<double>(cv::countNonZero(far & (cover > 0))) / cv::countNonZero(object);
  return score;
}

}  // namespace dorsum::accuracy
