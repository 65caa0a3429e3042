// SPDX-License-Identifier: Apache-2.0
#include "simulator/scene_tracer.h"

#include <stdexcept>

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

#include "simulator/mottle.h"

namespace dorsum {

namespace {

#if defined(__SANITIZE_THREAD__)
// Embree builds its trees with TBB, whose synchronisation ThreadSanitizer does not see.
constexpr const char* kEmbreeSettings = "threads=1";
#else
constexpr const char* kEmbreeSettings = nullptr;
#endif

}  // namespace

struct SceneTracer::Embree {
  RTCDevice device = rtcNewDevice(kEmbreeSettings);
  RTCScene scene = rtcNewScene(device);
  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

namespace {

void AddPart(RTCDevice device, RTCScene scene, const ScenePart& part, unsigned id) {
  const TriangleMesh& mesh = part.mesh;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  auto* faces = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.faces.size()));
  if (vertices == nullptr || faces == nullptr) {
    rtcReleaseGeometry(geometry);
    throw std::runtime_error("Embree: no memory for a mesh");
  }
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(v[i]);
  }
  for (const auto& f : mesh.faces) faces = std::copy(f.begin(), f.end(), faces);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

RTCRay EmbreeRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double tnear, double tfar) {
  RTCRay ray{};
  const Eigen::Vector3f o = origin.cast<float>(), d = direction.cast<float>();
  ray.org_x = o.x(), ray.org_y = o.y(), ray.org_z = o.z();
  ray.dir_x = d.x(), ray.dir_y = d.y(), ray.dir_z = d.z();
  ray.tnear = static_cast<float>(tnear);
  ray.tfar = static_cast<float>(tfar);
  ray.mask = ~0U;
  return ray;
}

}  // namespace

SceneTracer::SceneTracer(Scene scene) : scene_(std::move(scene)), embree_(std::make_unique<Embree>()) {
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips between two facets
  for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
    AddPart(embree_->device, embree_->scene, scene_.parts[i], static_cast<unsigned>(i));
  }
  rtcCommitScene(embree_->scene);
}

SceneTracer::~SceneTracer() = default;
SceneTracer::SceneTracer(SceneTracer&&) noexcept = default;
SceneTracer& SceneTracer::operator=(SceneTracer&&) noexcept = default;

std::optional<SurfaceHit> SceneTracer::Trace(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = EmbreeRay(ray.origin, ray.direction, 0.0, 1e30);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  const ScenePart& part = scene_.parts[query.hit.geomID];
  SurfaceHit hit;
  hit.part = static_cast<int>(query.hit.geomID);
  hit.face = part.mesh.faces[query.hit.primID];
  const auto& vertices = part.mesh.vertices;
  const Eigen::Vector3d &a = vertices[hit.face[0]], &b = vertices[hit.face[1]], &c = vertices[hit.face[2]];
  hit.face_normal = (b - a).cross(c - a).normalized();
  const double slope = hit.face_normal.dot(ray.direction);
  hit.distance_mm =
      std::abs(slope) > 1e-9 ? hit.face_normal.dot(a - ray.origin) / slope : double{query.ray.tfar};
  hit.position = ray.At(hit.distance_mm);
  const double u = query.hit.u, v = query.hit.v;
  hit.weights = {1.0 - u - v, u, v};
  hit.normal = hit.face_normal;
  if (!part.mesh.normals.empty()) {
    const auto& normals = part.mesh.normals;
    hit.normal = (hit.weights[0] * normals[hit.face[0]] + hit.weights[1] * normals[hit.face[1]] +
                  hit.weights[2] * normals[hit.face[2]])
                     .normalized();
  }
  if (slope > 0.0) {
    hit.face_normal = -hit.face_normal;
    hit.normal = -hit.normal;
  }
  return hit;
}

bool SceneTracer::Blocked(const Eigen::Vector3d& point, const Eigen::Vector3d& face_normal,
                          const Eigen::Vector3d& light) const {
  // Start a little above the surface: single precision knows points 400 mm away to about 0.0001 mm.
  const Eigen::Vector3d start = point + 0.01 * face_normal;
  const Eigen::Vector3d way = light - start;
  const double distance = way.norm();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = EmbreeRay(start, way / distance, 0.002, distance - 0.5);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0.0F;
}

Paint SceneTracer::PaintAt(const SurfaceHit& hit, double footprint_mm) const {
  const ScenePart& part = scene_.parts[static_cast<std::size_t>(hit.part)];
  const Eigen::Vector3d at = hit.position - part.moved;
  if (part.pattern) return part.pattern(at, footprint_mm);
  const auto interpolated = [&hit](const std::vector<float>& values) {
    return hit.weights[0] * double{values[hit.face[0]]} + hit.weights[1] * double{values[hit.face[1]]} +
           hit.weights[2] * double{values[hit.face[2]]};
  };
  Paint paint = part.paint;
  if (!part.vertex_albedo.empty()) paint.albedo = interpolated(part.vertex_albedo);
  if (!part.vertex_gloss.empty()) paint.gloss = interpolated(part.vertex_gloss);
  if (part.mottle > 0.0) paint.albedo *= 1.0 + part.mottle * Mottle(at);
  if (part.strands) paint.albedo *= part.strands(at, footprint_mm);
  return paint;
}

}  // namespace dorsum
