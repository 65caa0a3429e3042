// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/mesh.h"
#include "simulator/hand_pose.h"
#include "simulator/hand_shape.h"

namespace dorsum {

struct HandMesh {
  TriangleMesh mesh;                    // world frame, closed, resting on z = 0
  std::vector<Eigen::Vector3f> albedo;  // per vertex, linear RGB reflectance in [0, 1]
};

// The skin of a hand that lies palm down on the plane z = 0, fingers towards +x at zero yaw, with the forearm
// running out beyond x = -160. A right hand's thumb points to +y. The same input gives the same bytes.
// `resolution_mm` is the mesh's edge length; [0.3, 4].
HandMesh BuildHand(const HandShape& shape, Side side, const HandPose& pose, double resolution_mm = 0.7);

}  // namespace dorsum
