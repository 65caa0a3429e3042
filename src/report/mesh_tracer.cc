// SPDX-License-Identifier: Apache-2.0
#include "report/mesh_tracer.h"

#include <algorithm>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace dorsum {

namespace {

#if defined(__SANITIZE_THREAD__)
// Embree builds its trees with TBB, whose synchronisation ThreadSanitizer does not see.
constexpr const char* kEmbreeSettings = "threads=1";
#else
constexpr const char* kEmbreeSettings = nullptr;
#endif

}  // namespace

struct MeshTracer::Embree {
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

// Before Embree holds anything that a throw would leave behind.
void CheckFaces(const TriangleMesh& mesh) {
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t vertex : face) {
      if (vertex >= mesh.vertices.size()) {
        throw std::logic_error("MeshTracer: a face names a vertex that is not there");
      }
    }
  }
}

void AddTriangles(RTCDevice device, RTCScene scene, const TriangleMesh& mesh) {
  CheckFaces(mesh);
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
  for (const auto& face : mesh.faces) faces = std::copy(face.begin(), face.end(), faces);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

RTCRay EmbreeRay(const Ray& ray, double near_mm, double far_mm) {
  RTCRay out{};
  const Eigen::Vector3f o = ray.origin.cast<float>(), d = ray.direction.cast<float>();
  out.org_x = o.x(), out.org_y = o.y(), out.org_z = o.z();
  out.dir_x = d.x(), out.dir_y = d.y(), out.dir_z = d.z();
  out.tnear = static_cast<float>(near_mm);
  out.tfar = static_cast<float>(far_mm);
  out.mask = ~0U;
  return out;
}

}  // namespace

MeshTracer::MeshTracer(const TriangleMesh& mesh) : embree_(std::make_unique<Embree>()) {
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips between two facets
  if (!mesh.vertices.empty() && !mesh.faces.empty()) AddTriangles(embree_->device, embree_->scene, mesh);
  rtcCommitScene(embree_->scene);
}

MeshTracer::~MeshTracer() = default;
MeshTracer::MeshTracer(MeshTracer&&) noexcept = default;
MeshTracer& MeshTracer::operator=(MeshTracer&&) noexcept = default;

std::optional<MeshHit> MeshTracer::Trace(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = EmbreeRay(ray, 0.0, 1e30);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const double u = query.hit.u, v = query.hit.v;
  return MeshHit{query.hit.primID, query.ray.tfar, {1.0 - u - v, u, v}};
}

bool MeshTracer::IsBlocked(const Ray& ray, double near_mm, double far_mm) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = EmbreeRay(ray, near_mm, far_mm);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0.0F;
}

}  // namespace dorsum
