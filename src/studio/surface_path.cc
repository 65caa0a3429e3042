// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "studio/surface_measure.h"

namespace dorsum {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr std::uint32_t kCoarse = 3, kFine = 9;  // places on each edge
constexpr int kSweeps = 400;

struct Edge {
  std::uint32_t a = 0, b = 0;  // vertices, a < b
};

// The edges of a mesh and which faces meet at them.
struct EdgeTable {
  std::vector<Edge> edges;
  std::vector<std::array<std::uint32_t, 3>> of_face;
  std::vector<std::uint32_t> first;  // edge e's faces are faces[first[e]] to faces[first[e + 1] - 1]
  std::vector<std::uint32_t> faces;
};

EdgeTable MakeEdges(const TriangleMesh& mesh) {
  struct Side {
    Edge edge;
    std::uint32_t face, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.faces.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t p = mesh.faces[f][k], q = mesh.faces[f][(k + 1) % 3];
      sides.push_back({{std::min(p, q), std::max(p, q)}, f, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& l, const Side& r) {
    return l.edge.a != r.edge.a ? l.edge.a < r.edge.a : l.edge.b < r.edge.b;
  });
  EdgeTable table;
  table.of_face.resize(mesh.faces.size());
  for (const Side& side : sides) {
    if (table.edges.empty() || table.edges.back().a != side.edge.a || table.edges.back().b != side.edge.b) {
      table.edges.push_back(side.edge);
      table.first.push_back(static_cast<std::uint32_t>(table.faces.size()));
    }
    table.of_face[side.face][side.corner] = static_cast<std::uint32_t>(table.edges.size() - 1);
    table.faces.push_back(side.face);
  }
  table.first.push_back(static_cast<std::uint32_t>(table.faces.size()));
  return table;
}

Eigen::Vector3d On(const TriangleMesh& mesh, const Edge& edge, double share) {
  return (1.0 - share) * mesh.vertices[edge.a] + share * mesh.vertices[edge.b];
}

// Node n is place n % places of edge n / places.
double ShareOf(std::uint32_t node, std::uint32_t places) {
  return (2.0 * (node % places) + 1.0) / (2.0 * places);
}

// The faces that touch those along a way.
std::vector<char> FacesAbout(const TriangleMesh& mesh, const EdgeTable& table,
                             const std::vector<std::uint32_t>& way, std::uint32_t places) {
  std::vector<char> near_vertex(mesh.vertices.size(), 0), faces(mesh.faces.size(), 0);
  for (const std::uint32_t node : way) {
    const std::uint32_t edge = node / places;
    for (std::uint32_t i = table.first[edge]; i < table.first[edge + 1]; ++i) {
      for (const std::uint32_t v : mesh.faces[table.faces[i]]) near_vertex[v] = 1;
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::uint32_t v : mesh.faces[f]) faces[f] = near_vertex[v] != 0 ? 1 : faces[f];
  }
  return faces;
}

// A*: the straight distance that is left never exceeds the way that is left. Gives the nodes of the way
// through the allowed faces (all, if empty), and none where there is no way.
Result<std::vector<std::uint32_t>> FindWay(const TriangleMesh& mesh, const EdgeTable& table,
                                           const MeshPlace& from, const MeshPlace& to, std::uint32_t places,
                                           const std::vector<char>& allowed, const Context& context) {
  const std::size_t nodes = places * table.edges.size();
  std::vector<float> length(nodes, std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> before(nodes, kNone);
  std::vector<char> done(nodes, 0);
  using Item = std::pair<double, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  const auto place = [&](std::uint32_t node) {
    return On(mesh, table.edges[node / places], ShareOf(node, places));
  };
  const auto reach = [&](std::uint32_t node, std::uint32_t by, double way) {
    if (!(way < length[node])) return;
    length[node] = static_cast<float>(way);
    before[node] = by;
    open.emplace(way + (place(node) - to.position).norm(), node);
  };
  for (const std::uint32_t e : table.of_face[from.face]) {
    for (std::uint32_t k = 0; k < places; ++k) {
      const std::uint32_t node = places * e + k;
      reach(node, kNone, (place(node) - from.position).norm());
    }
  }
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t last = kNone;
  for (std::size_t visited = 0; !open.empty() && open.top().first < best; ++visited) {
    if (visited % 4096 == 0) DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    const std::uint32_t node = open.top().second;
    open.pop();
    if (done[node] != 0) continue;
    done[node] = 1;
    const Eigen::Vector3d here = place(node);
    const std::uint32_t edge = node / places;
    for (std::uint32_t i = table.first[edge]; i < table.first[edge + 1]; ++i) {
      const std::uint32_t face = table.faces[i];
      if (!allowed.empty() && allowed[face] == 0) continue;
      const double end = length[node] + (here - to.position).norm();
      if (face == to.face && end < best) {
        best = end;
        last = node;
      }
      for (const std::uint32_t other : table.of_face[face]) {
        if (other == edge) continue;
        for (std::uint32_t k = 0; k < places; ++k) {
          const std::uint32_t next = places * other + k;
          if (done[next] == 0) reach(next, node, length[node] + (place(next) - here).norm());
        }
      }
    }
  }
  std::vector<std::uint32_t> way;
  for (; last != kNone; last = before[last]) way.push_back(last);
  std::reverse(way.begin(), way.end());
  return way;
}

// The share of the edge at which the way from p to q, both beside the edge, is shortest: the two faces
// unfolded into one plane, p and q on either side.
double Straighten(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p,
                  const Eigen::Vector3d& q, double now) {
  const Eigen::Vector3d along = b - a;
  const double squared = along.squaredNorm();
  if (!(squared > 0.0)) return now;
  const double tp = along.dot(p - a) / squared, tq = along.dot(q - a) / squared;
  const double dp = (p - a - tp * along).norm(), dq = (q - a - tq * along).norm();
  if (!(dp + dq > 1e-12)) return now;
  return std::clamp((tp * dq + tq * dp) / (dp + dq), 0.0, 1.0);
}

double Length(const std::vector<Eigen::Vector3d>& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

}  // namespace

Result<SurfaceDistance> MeasureAlong(const TriangleMesh& mesh, const MeshPlace& from, const MeshPlace& to,
                                     const Context& context) {
  if (from.face >= mesh.faces.size() || to.face >= mesh.faces.size()) {
    throw std::logic_error("MeasureAlong: a place in a face that is not there");
  }
  SurfaceDistance distance;
  distance.straight_mm = distance.along_mm = (to.position - from.position).norm();
  distance.path = {from.position, to.position};
  if (from.face == to.face) return distance;
  const EdgeTable table = MakeEdges(mesh);
  DORSUM_ASSIGN_OR_RETURN(std::vector<std::uint32_t> way,
                          FindWay(mesh, table, from, to, kCoarse, {}, context));
  if (way.empty()) {
    return Error{ErrorCode::kAnswerIsNo,
                 "the two places lie on parts of the surface that do not touch; choose two on one part"};
  }
  // Finer places near that way tell on which side of each vertex the shortest runs.
  DORSUM_ASSIGN_OR_RETURN(
      way, FindWay(mesh, table, from, to, kFine, FacesAbout(mesh, table, way, kCoarse), context));
  std::vector<double> shares;
  distance.path = {from.position};
  for (const std::uint32_t node : way) {
    shares.push_back(ShareOf(node, kFine));
    distance.path.push_back(On(mesh, table.edges[node / kFine], shares.back()));
  }
  distance.path.push_back(to.position);
  double before = Length(distance.path);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Edge& edge = table.edges[way[i] / kFine];
      shares[i] = Straighten(mesh.vertices[edge.a], mesh.vertices[edge.b], distance.path[i],
                             distance.path[i + 2], shares[i]);
      distance.path[i + 1] = On(mesh, edge, shares[i]);
    }
    const double now = Length(distance.path);
    if (before - now < 1e-7 * now) break;
    before = now;
  }
  distance.along_mm = Length(distance.path);
  return distance;
}

}  // namespace dorsum
