// SPDX-License-Identifier: Apache-2.0
#include "simulator/surface_nets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace dorsum {
namespace {

constexpr int kBlock = 4;  // nodes per side of the blocks that are skipped together
constexpr std::uint32_t kNone = 0xffffffff;

struct Grid {
  Eigen::Vector3d lo;
  double cell;
  std::array<int, 3> nodes;
  std::vector<float> values;

  std::size_t Index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * nodes[1] + j) * nodes[0] + i;
  }
  Eigen::Vector3d At(double i, double j, double k) const { return lo + cell * Eigen::Vector3d(i, j, k); }
};

void FillBlock(const SignedDistance& distance, double steepness, int i0, int j0, int k0, Grid& grid) {
  const double middle = 0.5 * (kBlock - 1);
  const double at_centre = distance(grid.At(i0 + middle, j0 + middle, k0 + middle));
  // The farthest point of the cells that have a node here lies one cell beyond the outermost nodes.
  const double reach = std::sqrt(3.0) * (middle + 1) * grid.cell;
  const bool far = std::abs(at_centre) > steepness * reach;
  for (int k = k0; k < std::min(k0 + kBlock, grid.nodes[2]); ++k) {
    for (int j = j0; j < std::min(j0 + kBlock, grid.nodes[1]); ++j) {
      for (int i = i0; i < std::min(i0 + kBlock, grid.nodes[0]); ++i) {
        grid.values[grid.Index(i, j, k)] = static_cast<float>(far ? at_centre : distance(grid.At(i, j, k)));
      }
    }
  }
}

Grid Sample(const SignedDistance& distance, const SurfaceNetsOptions& options) {
  Grid grid;
  grid.lo = options.lo;
  grid.cell = options.cell;
  std::size_t count = 1;
  for (int a = 0; a < 3; ++a) {
    grid.nodes[a] = static_cast<int>(std::ceil((options.hi[a] - options.lo[a]) / options.cell)) + 1;
    count *= grid.nodes[a];
  }
  grid.values.resize(count);
  for (int k = 0; k < grid.nodes[2]; k += kBlock) {
    for (int j = 0; j < grid.nodes[1]; j += kBlock) {
      for (int i = 0; i < grid.nodes[0]; i += kBlock) FillBlock(distance, options.steepness, i, j, k, grid);
    }
  }
  return grid;
}

// Corners of a cell are numbered by bits: x, y, z. Which inside corners hang together along the cell's edges,
// for each of the 256 patterns: every such group has its own sheet of surface, and so its own vertex. One
// vertex for all would tie sheets together where they only pass each other.
struct Groups {
  std::array<std::array<std::uint8_t, 8>, 256> of_corner = {};
  std::array<std::uint8_t, 256> count = {};

  constexpr Groups() {
    for (int pattern = 0; pattern < 256; ++pattern) {
      std::array<bool, 8> seen = {};
      for (int start = 0; start < 8; ++start) {
        if (seen[start] || !(pattern >> start & 1)) continue;
        seen[start] = true;
        of_corner[pattern][start] = count[pattern];
        for (int pass = 0; pass < 8; ++pass) {
          for (int a = 0; a < 8; ++a) {
            if (!seen[a] || of_corner[pattern][a] != count[pattern]) continue;
            for (int b : {a ^ 1, a ^ 2, a ^ 4}) {
              if (!(pattern >> b & 1) || seen[b]) continue;
              seen[b] = true;
              of_corner[pattern][b] = count[pattern];
            }
          }
        }
        ++count[pattern];
      }
    }
  }
};
constexpr Groups kGroups;

int Pattern(const std::array<float, 8>& corner) {
  int pattern = 0;
  for (int c = 0; c < 8; ++c) pattern |= (corner[c] < 0) << c;
  return pattern;
}

std::array<float, 8> Corners(const Grid& grid, int i, int j, int k) {
  std::array<float, 8> corner;
  for (int c = 0; c < 8; ++c)
    corner[c] = grid.values[grid.Index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1))];
  return corner;
}

// The mean of the points where the surface of one group crosses the cell's edges, as an offset in cells.
Eigen::Vector3d MeanCrossing(const std::array<float, 8>& corner, int pattern, int group) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int crossings = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int a = 0; a < 8; ++a) {
      const int b = a | (1 << axis);
      if (a == b || (corner[a] < 0) == (corner[b] < 0)) continue;
      if (kGroups.of_corner[pattern][corner[a] < 0 ? a : b] != group) continue;
      Eigen::Vector3d point(a & 1, (a >> 1) & 1, (a >> 2) & 1);
      point[axis] = corner[a] / (static_cast<double>(corner[a]) - corner[b]);
      sum += point;
      ++crossings;
    }
  }
  return sum / crossings;
}

// Two triangles, split along the shorter diagonal.
void AddQuad(std::array<std::uint32_t, 4> q, bool flip, TriangleMesh& mesh) {
  if (flip) std::swap(q[1], q[3]);
  const auto& v = mesh.vertices;
  const bool first = (v[q[0]] - v[q[2]]).squaredNorm() <= (v[q[1]] - v[q[3]]).squaredNorm();
  if (first) {
    mesh.faces.push_back({q[0], q[1], q[2]});
    mesh.faces.push_back({q[0], q[2], q[3]});
  } else {
    mesh.faces.push_back({q[1], q[2], q[3]});
    mesh.faces.push_back({q[1], q[3], q[0]});
  }
}

void AddVertices(const Grid& grid, std::vector<std::uint32_t>& first_vertex, TriangleMesh& mesh) {
  for (int k = 0; k + 1 < grid.nodes[2]; ++k) {
    for (int j = 0; j + 1 < grid.nodes[1]; ++j) {
      for (int i = 0; i + 1 < grid.nodes[0]; ++i) {
        const std::array<float, 8> corner = Corners(grid, i, j, k);
        const int pattern = Pattern(corner);
        if (pattern == 0 || pattern == 255) continue;
        first_vertex[grid.Index(i, j, k)] = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int group = 0; group < kGroups.count[pattern]; ++group) {
          const Eigen::Vector3d offset = MeanCrossing(corner, pattern, group);
          mesh.vertices.push_back(grid.At(i + offset.x(), j + offset.y(), k + offset.z()));
        }
      }
    }
  }
}

// A crossed edge along `axis` is shared by four cells; their vertices make a quad that faces away from
// inside.
void AddFaces(const Grid& grid, const std::vector<std::uint32_t>& first_vertex, TriangleMesh& mesh) {
  for (int k = 1; k + 1 < grid.nodes[2]; ++k) {
    for (int j = 1; j + 1 < grid.nodes[1]; ++j) {
      for (int i = 1; i + 1 < grid.nodes[0]; ++i) {
        const bool inside = grid.values[grid.Index(i, j, k)] < 0;
        for (int axis = 0; axis < 3; ++axis) {
          const std::array<int, 3> here = {i, j, k};
          std::array<int, 3> next = here;
          ++next[axis];
          if (inside == (grid.values[grid.Index(next[0], next[1], next[2])] < 0)) continue;
          std::array<int, 3> b = {}, c = {};
          b[(axis + 1) % 3] = 1;
          c[(axis + 2) % 3] = 1;
          auto cell = [&](int nb, int nc) {
            const int ci = i - nb * b[0] - nc * c[0], cj = j - nb * b[1] - nc * c[1],
                      ck = k - nb * b[2] - nc * c[2];
            const std::array<int, 3>& in = inside ? here : next;
            const int corner = (in[0] - ci) | (in[1] - cj) << 1 | (in[2] - ck) << 2;
            return first_vertex[grid.Index(ci, cj, ck)] +
                   kGroups.of_corner[Pattern(Corners(grid, ci, cj, ck))][corner];
          };
          AddQuad({cell(1, 1), cell(0, 1), cell(0, 0), cell(1, 0)}, !inside, mesh);
        }
      }
    }
  }
}

}  // namespace

Eigen::Vector3d Gradient(const SignedDistance& distance, const Eigen::Vector3d& point, double step) {
  static const Eigen::Vector3d kCorners[4] = {{1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {1, 1, 1}};
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : kCorners) gradient += distance(point + step * corner) * corner;
  return gradient / (4 * step);
}

TriangleMesh SurfaceNets(const SignedDistance& distance, const SurfaceNetsOptions& options) {
  if (!(options.cell > 0) || !(options.lo.array() < options.hi.array()).all()) {
    throw std::logic_error("surface nets need a cell and a box with room");
  }
  TriangleMesh mesh;
  const Grid grid = Sample(distance, options);
  std::vector<std::uint32_t> first_vertex(grid.values.size(), kNone);
  AddVertices(grid, first_vertex, mesh);
  AddFaces(grid, first_vertex, mesh);
  mesh.normals.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    Eigen::Vector3d& point = mesh.vertices[v];
    const Eigen::Vector3d gradient = Gradient(distance, point);
    for (int step = 0; step < options.newton_steps; ++step) {
      Eigen::Vector3d move = -distance(point) / std::max(gradient.squaredNorm(), 0.1) * gradient;
      const double limit = 0.5 * options.cell / options.newton_steps;
      if (move.norm() > limit) move *= limit / move.norm();
      point += move;
    }
    mesh.normals[v] = Gradient(distance, point).normalized();
  }
  return mesh;
}

}  // namespace dorsum
