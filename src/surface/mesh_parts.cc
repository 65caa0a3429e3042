// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh_parts.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = MeshPart::kNone;

// What is found out about a part's vertices.
struct Vertices {
  std::vector<char> kept;                // 1: a face has it, and no part before does
  std::vector<Eigen::Vector3d> areas;    // of its faces, the sum of the vectors
  std::vector<std::uint32_t> in_before;  // of the shared ones: the part before's; otherwise kNone
  std::vector<std::uint32_t> to;         // in the whole mesh
};

Vertices LookAt(const TriangleMesh& mesh) {
  Vertices out;
  out.kept.assign(mesh.vertices.size(), 0);
  out.areas.assign(mesh.vertices.size(), Eigen::Vector3d::Zero());
  out.in_before.assign(mesh.vertices.size(), kNone);
  out.to.assign(mesh.vertices.size(), kNone);
  for (const auto& f : mesh.faces) {
    const Eigen::Vector3d& a = mesh.vertices[f[0]];
    const Eigen::Vector3d area = (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a);
    for (const std::uint32_t i : f) {
      out.kept[i] = 1;
      out.areas[i] += area;
    }
  }
  return out;
}

// Gives what two parts share to the first of them.
void Share(const MeshPart& before, const MeshPart& part, Vertices* of_before, Vertices* of_part) {
  for (std::size_t i = 0; i < std::min(before.last.size(), part.first.size()); ++i) {
    const std::uint32_t theirs = before.last[i], own = part.first[i];
    if (theirs == kNone || own == kNone) continue;
    if (of_part->kept[own] != 0) of_before->kept[theirs] = 1;
    of_before->areas[theirs] += of_part->areas[own];
    of_part->kept[own] = 0;
    of_part->in_before[own] = theirs;
  }
}

}  // namespace

TriangleMesh JoinParts(const std::vector<MeshPart>& parts, const Context& context) {
  std::vector<Vertices> all(parts.size());
  const auto for_parts = [&](const auto& body) {
    ParallelFor(context, 0, static_cast<std::int64_t>(parts.size()), [&](std::int64_t k) {
      body(static_cast<std::size_t>(k), parts[static_cast<std::size_t>(k)].mesh,
           all[static_cast<std::size_t>(k)]);
    });
  };
  for_parts([](std::size_t, const TriangleMesh& mesh, Vertices& own) { own = LookAt(mesh); });
  std::vector<std::size_t> first_vertex = {0}, first_face = {0};
  for (std::size_t k = parts.size(); k-- > 1;) Share(parts[k - 1], parts[k], &all[k - 1], &all[k]);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto kept = std::count(all[k].kept.begin(), all[k].kept.end(), 1);
    first_vertex.push_back(first_vertex.back() + static_cast<std::size_t>(kept));
    first_face.push_back(first_face.back() + parts[k].mesh.faces.size());
  }
  TriangleMesh whole;
  whole.vertices.resize(first_vertex.back());
  whole.normals.resize(first_vertex.back());
  whole.faces.resize(first_face.back());
  for_parts([&](std::size_t k, const TriangleMesh& mesh, Vertices& own) {
    std::size_t next = first_vertex[k];
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      if (own.kept[i] == 0) continue;
      whole.vertices[next] = mesh.vertices[i];
      whole.normals[next] = own.areas[i].normalized();
      own.to[i] = static_cast<std::uint32_t>(next++);
    }
  });
  for_parts([&](std::size_t k, const TriangleMesh& mesh, const Vertices& own) {
    const auto id = [&](std::uint32_t i) {
      return own.in_before[i] == kNone ? own.to[i] : all[k - 1].to[own.in_before[i]];
    };
    std::size_t next = first_face[k];
    for (const auto& f : mesh.faces) whole.faces[next++] = {id(f[0]), id(f[1]), id(f[2])};
  });
  return whole;
}

}  // namespace dorsum
