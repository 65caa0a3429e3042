// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "studio/surface_measure.h"

namespace dorsum {
namespace {

struct Line {
  Eigen::Vector2d start, direction;
  double length = 0.0;
  double Along(const Eigen::Vector3d& p) const { return direction.dot(p.head<2>() - start); }
  double Beside(const Eigen::Vector3d& p) const {
    const Eigen::Vector2d d = p.head<2>() - start;
    return direction.x() * d.y() - direction.y() * d.x();
  }
};

Result<Line> MakeLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector2d d = (b - a).head<2>();
  if (!(d.norm() > 1e-6)) {
    return UsageError("the two places stand one above the other; choose two that lie side by side");
  }
  return Line{a.head<2>(), d.normalized(), d.norm()};
}

// Crossings of the plane with edges, and which of them a face joins.
struct Crossings {
  std::vector<Eigen::Vector2d> places;            // s, z
  std::vector<std::array<std::int64_t, 2>> next;  // -1: none
  std::unordered_map<std::uint64_t, std::size_t> by_edge;
};

std::size_t CrossingOf(const TriangleMesh& mesh, const Line& line, std::uint32_t p, std::uint32_t q,
                       Crossings* all) {
  if (p > q) std::swap(p, q);
  const auto [found, is_new] =
      all->by_edge.try_emplace((static_cast<std::uint64_t>(p) << 32) | q, all->places.size());
  if (is_new) {
    const Eigen::Vector3d &a = mesh.vertices[p], &b = mesh.vertices[q];
    const double da = line.Beside(a), db = line.Beside(b), share = da / (da - db);
    const Eigen::Vector3d at = a + share * (b - a);
    all->places.emplace_back(line.Along(at), at.z());
    all->next.push_back({-1, -1});
  }
  return found->second;
}

void Join(Crossings* all, std::size_t from, std::size_t to) {
  for (std::int64_t& slot : all->next[from]) {
    if (slot >= 0) continue;
    slot = static_cast<std::int64_t>(to);
    return;
  }
}

// Follows the joins from one crossing to the end, or once round.
SectionCurve Follow(const Crossings& all, std::size_t start, std::vector<char>* seen) {
  SectionCurve curve;
  for (std::optional<std::size_t> at = start; at;) {
    (*seen)[*at] = 1;
    curve.push_back(all.places[*at]);
    std::optional<std::size_t> next;
    for (const std::int64_t n : all.next[*at]) {
      if (n >= 0 && (*seen)[static_cast<std::size_t>(n)] == 0) {
        next = static_cast<std::size_t>(n);
        break;
      }
    }
    if (!next && curve.size() > 2) {
      const auto& ends = all.next[*at];
      const auto first = static_cast<std::int64_t>(start);
      if (ends[0] == first || ends[1] == first) curve.push_back(all.places[start]);  // closed
    }
    at = next;
  }
  if (curve.front().x() > curve.back().x()) std::reverse(curve.begin(), curve.end());
  return curve;
}

}  // namespace

Result<Section> CutMesh(const TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  DORSUM_ASSIGN_OR_RETURN(const Line line, MakeLine(a, b));
  std::vector<char> left(mesh.vertices.size());  // a vertex in the plane counts as left: no face is cut once
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = line.Beside(mesh.vertices[i]) >= 0.0 ? 1 : 0;
  Crossings all;
  for (const auto& f : mesh.faces) {
    std::array<std::size_t, 2> cut{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = f[k], q = f[(k + 1) % 3];
      if (left[p] != left[q] && count < 2) cut[count++] = CrossingOf(mesh, line, p, q, &all);
    }
    if (count < 2) continue;
    Join(&all, cut[0], cut[1]);
    Join(&all, cut[1], cut[0]);
  }
  Section section;
  section.length_mm = line.length;
  std::vector<char> seen(all.places.size(), 0);
  for (const bool ends_only : {true, false}) {  // open curves from their ends; what is left is closed
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] != 0 || (ends_only && all.next[i][1] >= 0)) continue;
      section.curves.push_back(Follow(all, i, &seen));
    }
  }
  std::sort(section.curves.begin(), section.curves.end(),
            [](const SectionCurve& l, const SectionCurve& r) { return l.front().x() < r.front().x(); });
  return section;
}

Result<Section> CutPoints(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, double reach_mm) {
  DORSUM_ASSIGN_OR_RETURN(const Line line, MakeLine(a, b));
  Section section;
  section.length_mm = line.length;
  for (const Eigen::Vector3d& p : points) {
    if (std::abs(line.Beside(p)) <= reach_mm) section.dots.emplace_back(line.Along(p), p.z());
  }
  std::sort(section.dots.begin(), section.dots.end(),
            [](const Eigen::Vector2d& l, const Eigen::Vector2d& r) { return l.x() < r.x(); });
  return section;
}

}  // namespace dorsum
