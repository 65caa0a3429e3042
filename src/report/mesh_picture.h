// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/mesh.h"
#include "report/mesh_light.h"
#include "report/mesh_tracer.h"

namespace dorsum {

// From where a mesh is looked at. Azimuth 0 stands at the lower edge of the height map and looks along +y,
// 90 stands at its right edge; elevation 90 looks straight down, as the camera does.
struct MeshView {
  double azimuth_deg = 0.0;
  double elevation_deg = 40.0;  // 5 to 90
};

// The two sides from which the reports show a surface.
inline constexpr MeshView kFrontView{-28.0, 42.0};
inline constexpr MeshView kBackView{152.0, 42.0};

struct MeshPictureOptions {
  cv::Size size{1080, 810};
  int samples = 2;                // rays per pixel and direction, 1 to 8
  bool colour_by_height = false;  // the map's colours instead of clay
  bool floor = true;              // the backplane with a 10 mm grid and the mesh's soft shadow
};

// A mesh prepared for pictures from any side; parallel projection, light from above left, no display needed.
class MeshPainter {
 public:
  MeshPainter(TriangleMesh mesh, const MeshPictureOptions& options, Context context = {});
  cv::Mat Paint(const MeshView& view) const;

 private:
  struct Frame;
  struct Light;
  cv::Vec3f Shade(const Ray& ray, const Light& light, const cv::Vec3f& background) const;
  cv::Vec3f ShadeMesh(const MeshHit& hit, const Ray& ray, const Light& light) const;
  cv::Vec3f ShadeFloorAt(const Ray& ray, const cv::Vec3f& background) const;
  Frame FrameFor(const MeshView& view) const;

  TriangleMesh mesh_;
  MeshPictureOptions options_;
  Context context_;
  MeshTracer tracer_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<float> sky_;
  FloorShadow floor_;
  double low_z_ = 0.0, high_z_ = 1.0;
};

// One picture of a mesh (CV_8UC3); an empty mesh gives the bare background.
cv::Mat RenderMesh(const TriangleMesh& mesh, const MeshView& view, const MeshPictureOptions& options = {},
                   const Context& context = {});

}  // namespace dorsum
