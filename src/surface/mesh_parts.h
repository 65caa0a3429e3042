// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/context.h"
#include "geometry/mesh.h"

namespace dorsum {

// A part of a mesh that was made beside others of it.
struct MeshPart {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  TriangleMesh mesh;  // without normals
  // Vertices on the borders to the part before and to the one behind, place by place the same as those that
  // the neighbour has there; kNone where there is none.
  std::vector<std::uint32_t> first, last;
};

// One mesh of parts that follow each other, with each shared vertex once, without the vertices that no face
// has, and with normals. The same at any number of threads.
TriangleMesh JoinParts(const std::vector<MeshPart>& parts, const Context& context);

}  // namespace dorsum
