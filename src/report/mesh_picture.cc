// SPDX-License-Identifier: Apache-2.0
#include "report/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/parallel.h"
#include "report/colours.h"

namespace dorsum {
namespace {

constexpr double kSkyReachMm = 25.0;
constexpr double kFloorGridMm = 10.0;
const cv::Vec3f kClay(0.36F, 0.52F, 0.74F);    // linear light, blue first
const cv::Vec3f kInside(0.26F, 0.24F, 0.23F);  // a surface seen from below
const cv::Vec3f kSkyTop(0.88F, 0.86F, 0.85F), kSkyBottom(0.74F, 0.71F, 0.69F);

float Linear(double srgb) { return static_cast<float>(std::pow(srgb / 255.0, 2.2)); }

Colour Encode(const cv::Vec3f& linear) {
  Colour out;
  for (int i = 0; i < 3; ++i) {
    out[i] = cv::saturate_cast<unsigned char>(255.0 *
                                              std::pow(std::clamp(double(linear[i]), 0.0, 1.0), 1.0 / 2.2));
  }
  return out;
}

// 1 on a grid line, 0 between them, soft by the width of a sample.
double GridLine(double position, double width_mm) {
  const double off = std::abs(position - kFloorGridMm * std::round(position / kFloorGridMm));
  return std::clamp(1.0 - off / width_mm, 0.0, 1.0);
}

}  // namespace

// Maps picture coordinates to rays.
struct MeshPainter::Frame {
  Eigen::Vector3d right, up, towards;  // unit; `towards` points at the viewer
  Eigen::Vector3d centre;
  double mm_per_px = 1.0;
};

struct MeshPainter::Light {
  Eigen::Vector3d key, head;  // unit, towards the light above left and towards the viewer
};

MeshPainter::MeshPainter(TriangleMesh mesh, const MeshPictureOptions& options, Context context)
    : mesh_(std::move(mesh)),
      options_(options),
      context_(std::move(context)),
      tracer_(mesh_),
      normals_(VertexNormals(mesh_)),
      sky_(VertexSky(mesh_, normals_, tracer_, kSkyReachMm, context_)) {
  if (options_.floor) floor_ = ShadeFloor(mesh_, tracer_, kSkyReachMm, context_);
  std::vector<double> heights;
  for (const Eigen::Vector3d& v : mesh_.vertices) {
    if (v.allFinite()) heights.push_back(v.z());
  }
  if (heights.empty()) return;
  std::sort(heights.begin(), heights.end());
  const std::size_t cut = heights.size() / 200;
  low_z_ = heights[cut];
  high_z_ = std::max(heights[heights.size() - 1 - cut], low_z_ + 1e-3);
}

MeshPainter::Frame MeshPainter::FrameFor(const MeshView& view) const {
  const double azimuth = view.azimuth_deg * std::numbers::pi / 180.0;
  const double elevation = view.elevation_deg * std::numbers::pi / 180.0;
  Frame frame;
  frame.right = {std::cos(azimuth), std::sin(azimuth), 0.0};
  frame.towards = {std::cos(elevation) * std::sin(azimuth), -std::cos(elevation) * std::cos(azimuth),
                   std::sin(elevation)};
  frame.up = frame.towards.cross(frame.right);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
  for (const Eigen::Vector3d& v : mesh_.vertices) {
    if (!v.allFinite()) continue;
    const Eigen::Vector2d p(frame.right.dot(v), frame.up.dot(v));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (!(low.array() <= high.array()).all()) low.setConstant(-50.0), high.setConstant(50.0);
  const Eigen::Vector2d middle = 0.5 * (low + high), size = (high - low).cwiseMax(1.0);
  frame.mm_per_px = 1.1 * std::max(size.x() / options_.size.width, size.y() / options_.size.height);
  frame.centre = middle.x() * frame.right + middle.y() * frame.up + 5000.0 * frame.towards;
  return frame;
}

cv::Vec3f MeshPainter::ShadeMesh(const MeshHit& hit, const Ray& ray, const Light& light) const {
  const auto& face = mesh_.faces[hit.face];
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double sky = 0.0, z = 0.0;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t vertex = face[static_cast<std::size_t>(i)];
    normal += hit.weights[i] * normals_[vertex];
    sky += hit.weights[i] * double{sky_[vertex]};
    z += hit.weights[i] * mesh_.vertices[vertex].z();
  }
  normal.normalize();
  cv::Vec3f albedo = kClay;
  if (options_.colour_by_height) {
    const Colour c = SequentialColour((z - low_z_) / (high_z_ - low_z_));
    albedo = {Linear(c[0]), Linear(c[1]), Linear(c[2])};
  }
  const Eigen::Vector3d& a = mesh_.vertices[face[0]];
  const Eigen::Vector3d outwards = (mesh_.vertices[face[1]] - a).cross(mesh_.vertices[face[2]] - a);
  if (outwards.dot(ray.direction) > 0.0) {
    normal = -normal;
    albedo = kInside;
    sky = 0.5;
  }
  const double key = std::max(0.0, normal.dot(light.key)), head = std::max(0.0, normal.dot(light.head));
  const double diffuse = sky * sky * (0.16 + 0.14 * head) + (0.3 + 0.7 * sky) * 0.82 * key;
  const double gloss =
      0.05 * sky * std::pow(std::max(0.0, normal.dot((light.key + light.head).normalized())), 24.0);
  return albedo * static_cast<float>(diffuse) + cv::Vec3f::all(static_cast<float>(gloss));
}

cv::Vec3f MeshPainter::ShadeFloorAt(const Ray& ray, const cv::Vec3f& background) const {
  if (!options_.floor || floor_.sky.empty() || ray.direction.z() > -1e-3) return background;
  const Eigen::Vector3d p = ray.At(-ray.origin.z() / ray.direction.z());
  const Eigen::Vector2d size(floor_.sky.cols * floor_.pitch_mm, floor_.sky.rows * floor_.pitch_mm);
  const Eigen::Vector2d middle = floor_.origin_mm + 0.5 * size;
  // The grid fades out towards an ellipse around the mesh, so that it ends nowhere abruptly.
  const double away = (p.head<2>() - middle).cwiseQuotient(0.5 * size).norm();
  const double fade = std::clamp(2.2 - 1.5 * away, 0.0, 1.0);
  const double line = fade * std::max(GridLine(p.x(), 0.35), GridLine(p.y(), 0.35));
  const double sky = floor_.At(p.x(), p.y());
  return background * static_cast<float>((1.0 - 0.22 * line) * (0.35 + 0.65 * sky));
}

cv::Vec3f MeshPainter::Shade(const Ray& ray, const Light& light, const cv::Vec3f& background) const {
  const std::optional<MeshHit> hit = tracer_.Trace(ray);
  return hit ? ShadeMesh(*hit, ray, light) : ShadeFloorAt(ray, background);
}

cv::Mat MeshPainter::Paint(const MeshView& view) const {
  const Frame frame = FrameFor(view);
  const Light light{(-0.75 * frame.right + 0.6 * frame.up + 0.5 * frame.towards).normalized(), frame.towards};
  cv::Mat picture(options_.size, CV_8UC3);
  const int n = std::clamp(options_.samples, 1, 8);
  ParallelFor(context_, 0, picture.rows, [&](std::int64_t i) {
    const int row = static_cast<int>(i);
    const auto down = static_cast<float>((row + 0.5) / picture.rows);
    const cv::Vec3f background = kSkyTop * (1.0F - down) + kSkyBottom * down;
    for (int column = 0; column < picture.cols; ++column) {
      cv::Vec3f sum(0.0F, 0.0F, 0.0F);
      for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) {
          const double x = (column + (a + 0.5) / n - 0.5 * picture.cols) * frame.mm_per_px;
          const double y = (0.5 * picture.rows - row - (b + 0.5) / n) * frame.mm_per_px;
          sum += Shade({frame.centre + x * frame.right + y * frame.up, -frame.towards}, light, background);
        }
      }
      picture.at<Colour>(row, column) = Encode(sum * (1.0F / static_cast<float>(n * n)));
    }
  });
  return picture;
}

cv::Mat RenderMesh(const TriangleMesh& mesh, const MeshView& view, const MeshPictureOptions& options,
                   const Context& context) {
  return MeshPainter(mesh, options, context).Paint(view);
}

}  // namespace dorsum
