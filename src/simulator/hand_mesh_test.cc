// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "simulator/hand_skeleton.h"
#include "simulator/hand_skin.h"

namespace dorsum {
namespace {

constexpr double kCoarse = 1.5;  // mm: enough for everything but small measures

HandShape Person(std::uint64_t seed) {
  Rng rng(seed);
  return SampleHandShape(seed % 2 ? Sex::kMan : Sex::kWoman, rng);
}

HandPose PoseOf(std::uint64_t seed) {
  Rng rng(seed + 1000);
  return SampleHandPose(rng);
}

struct Extent {
  double lo = 1e9, hi = -1e9;
  void Add(double value) {
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  double Size() const { return hi - lo; }
};

// Breadth of the mesh in a thin slice square to a finger's direction at a joint.
double BreadthAt(const TriangleMesh& mesh, const FingerBones& bones, const Eigen::Vector3d& joint,
                 double expected) {
  const Eigen::Vector2d left(-bones.direction.y(), bones.direction.x());
  Extent extent;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    const Eigen::Vector2d offset = (v - joint).head<2>();
    if (std::abs(offset.dot(bones.direction)) < 0.7 && std::abs(offset.dot(left)) < 0.65 * expected) {
      extent.Add(offset.dot(left));
    }
  }
  return extent.Size();
}

TEST(HandMeshTest, MeasuresAgreeWithTheShape) {
  for (std::uint64_t seed : {11, 12, 13}) {
    const HandShape shape = Person(seed);
    HandPose pose = PoseOf(seed);
    pose.yaw = 0;
    pose.centre.setZero();
    const TriangleMesh mesh = BuildHand(shape, Side::kRight, pose).mesh;
    const HandSkeleton skeleton = BuildSkeleton(shape, pose);
    for (int i = 0; i < 4; ++i) {
      const FingerBones& bones = skeleton.fingers[i];
      const FingerShape& finger = shape.fingers[i];
      // Half a vertex spacing at each side of a round section, and relief and creases of 0.1 mm.
      EXPECT_NEAR(BreadthAt(mesh, bones, bones.pip, finger.pip_breadth), finger.pip_breadth, 0.35);
      EXPECT_NEAR(BreadthAt(mesh, bones, bones.dip, finger.dip_breadth), finger.dip_breadth, 0.35);
      Extent reach;
      for (const Eigen::Vector3d& v : mesh.vertices) {
        const Eigen::Vector2d offset = (v - bones.dip).head<2>();
        if (offset.norm() < finger.distal_link + 3) reach.Add(offset.dot(bones.direction));
      }
      const double tip = (bones.tip - bones.dip).head<2>().dot(bones.direction);
      EXPECT_NEAR(reach.hi, tip, 0.4);
      // From the tip to the midpoint of the base, with the finger's slope (at most 12 deg) seen from above.
      const double base = (bones.mcp - bones.dip).head<2>().dot(bones.direction) + finger.proximal_link +
                          finger.middle_link + finger.distal_link - finger.length;
      EXPECT_NEAR(reach.hi - base, finger.length, 2.5);
    }
    Extent radial, ulnar;
    for (const Eigen::Vector3d& v : mesh.vertices) {
      if (std::abs(v.x() - skeleton.fingers[0].mcp.x()) < 2) radial.Add(v.y());
      if (std::abs(v.x() - skeleton.fingers[3].mcp.x()) < 6) ulnar.Add(v.y());
    }
    double index_side = -1e9;  // the thumb lies beyond the index finger's side in the same slice
    for (const Eigen::Vector3d& v : mesh.vertices) {
      if (std::abs(v.x() - skeleton.fingers[0].mcp.x()) < 2 &&
          v.y() < skeleton.fingers[0].mcp.y() + 0.24 * shape.hand_breadth) {
        index_side = std::max(index_side, v.y());
      }
    }
    // Soft tissue of the first web and seams between parts: 3 % of the breadth.
    EXPECT_NEAR(index_side - ulnar.lo, PalmBreadth(shape, pose), 0.03 * PalmBreadth(shape, pose));
  }
}

TEST(HandMeshTest, RestsOnThePlane) {
  for (std::uint64_t seed : {21, 22, 23, 24}) {
    Extent height, along;
    for (const Eigen::Vector3d& v :
         BuildHand(Person(seed), Side::kLeft, PoseOf(seed), kCoarse).mesh.vertices) {
      height.Add(v.z());
      along.Add(v.x());
    }
    EXPECT_GE(height.lo, 0.0);
    EXPECT_LT(height.lo, 1e-6);
    EXPECT_LT(height.hi, 70.0);
    EXPECT_LT(along.lo, -160.0);
    EXPECT_LT(along.hi, 135.0);
  }
}

TEST(HandMeshTest, IsClosedAndTurnsOutwards) {
  for (std::uint64_t seed : {31, 32}) {
    const TriangleMesh mesh = BuildHand(Person(seed), Side::kRight, PoseOf(seed), 1.0).mesh;
    std::unordered_map<std::uint64_t, int> edges;
    double six_volumes = 0;
    for (const auto& f : mesh.faces) {
      for (int k = 0; k < 3; ++k) ++edges[static_cast<std::uint64_t>(f[k]) << 32 | f[(k + 1) % 3]];
      const Eigen::Vector3d &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
      six_volumes += a.dot(b.cross(c));
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(edges.count(edge << 32 | edge >> 32), 1u);
    }
    EXPECT_GT(six_volumes / 6, 3e5);  // a hand and a part of the forearm: 0.3 to 0.8 litres
    EXPECT_LT(six_volumes / 6, 9e5);
    EXPECT_EQ(static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size() / 2) +
                  static_cast<long>(mesh.faces.size()),
              2);  // one piece without a hole
  }
}

TEST(HandMeshTest, NormalsAgreeWithFaces) {
  const TriangleMesh mesh = BuildHand(Person(41), Side::kLeft, PoseOf(41), 0.7).mesh;
  std::size_t off = 0;
  for (const auto& f : mesh.faces) {
    const Eigen::Vector3d &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
    const Eigen::Vector3d face = (b - a).cross(c - a).normalized();
    for (int k = 0; k < 3; ++k) off += face.dot(mesh.normals[f[k]]) < 0.9;
  }
  EXPECT_LT(off, mesh.faces.size() * 3 / 200);
  for (const Eigen::Vector3d& normal : mesh.normals) EXPECT_NEAR(normal.norm(), 1.0, 1e-9);
}

TEST(HandMeshTest, FacetsDoNotShow) {
  const HandShape shape = Person(42);
  const TriangleMesh mesh = BuildHand(shape, Side::kRight, HandPose()).mesh;
  const HandSkin skin(shape, HandPose());
  std::size_t off = 0, count = 0;
  for (const auto& f : mesh.faces) {
    const Eigen::Vector3d centre = (mesh.vertices[f[0]] + mesh.vertices[f[1]] + mesh.vertices[f[2]]) / 3;
    if (centre.z() < 5 || ++count % 5 != 0) continue;  // not the edge of the contact with the plane
    off += std::abs(skin.Distance(centre)) > 0.02;
  }
  EXPECT_LT(off, count / 5 / 40);  // the rest lies in wrinkles and at the nails' rims
}

// Counts the pieces of the section by the plane across the fingers and the thumb: vertices within half a
// millimetre of a polyline through the middle phalanges, gathered by gaps between them.
TEST(HandMeshTest, FingersStayApart) {
  for (std::uint64_t seed = 51; seed < 57; ++seed) {
    const HandShape shape = Person(seed);
    HandPose pose = PoseOf(seed);
    pose.yaw = 0;
    pose.centre.setZero();
    const TriangleMesh mesh = BuildHand(shape, Side::kRight, pose, 1.0).mesh;
    const HandSkeleton skeleton = BuildSkeleton(shape, pose);
    std::array<Eigen::Vector2d, 5> line;
    line[0] = (0.5 * (skeleton.thumb.ip + skeleton.thumb.tip)).head<2>();
    for (int i = 0; i < 4; ++i)
      line[i + 1] = (0.5 * (skeleton.fingers[i].pip + skeleton.fingers[i].dip)).head<2>();
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector2d along = line[i + 1] - line[i];
      std::vector<double> at;
      for (const Eigen::Vector3d& v : mesh.vertices) {
        const Eigen::Vector2d offset = v.head<2>() - line[i];
        const double t = offset.dot(along) / along.norm();
        const double off = (along.x() * offset.y() - along.y() * offset.x()) / along.norm();
        if (std::abs(off) < 0.9 && t > 0 && t < along.norm()) at.push_back(t);
      }
      std::sort(at.begin(), at.end());
      int gaps = 0;
      for (std::size_t k = 1; k < at.size(); ++k) gaps += at[k] - at[k - 1] > 0.65 * kFingerClearance;
      EXPECT_EQ(gaps, 1) << "seed " << seed << " between digits " << i + 1 << " and " << i + 2;
    }
  }
}

TEST(HandMeshTest, LeftMirrorsRight) {
  const HandShape shape = Person(71);
  HandPose pose = PoseOf(71), mirrored = pose;
  mirrored.yaw = -pose.yaw;
  mirrored.centre.y() = -pose.centre.y();
  const HandMesh right = BuildHand(shape, Side::kRight, pose, kCoarse);
  const HandMesh left = BuildHand(shape, Side::kLeft, mirrored, kCoarse);
  ASSERT_EQ(right.mesh.vertices.size(), left.mesh.vertices.size());
  for (std::size_t v = 0; v < right.mesh.vertices.size(); ++v) {
    const Eigen::Vector3d flip(1, -1, 1);
    EXPECT_LT((right.mesh.vertices[v].cwiseProduct(flip) - left.mesh.vertices[v]).norm(), 1e-9);
    EXPECT_LT((right.mesh.normals[v].cwiseProduct(flip) - left.mesh.normals[v]).norm(), 1e-9);
  }
  EXPECT_EQ(right.mesh.faces[9][1], left.mesh.faces[9][2]);
}

TEST(HandMeshTest, ThumbOfARightHandLiesAtPositiveY) {
  Extent right, left;
  for (const Eigen::Vector3d& v : BuildHand(Person(1), Side::kRight, HandPose(), 3.0).mesh.vertices)
    right.Add(v.y());
  for (const Eigen::Vector3d& v : BuildHand(Person(1), Side::kLeft, HandPose(), 3.0).mesh.vertices)
    left.Add(v.y());
  EXPECT_GT(right.hi, -right.lo + 5);
  EXPECT_LT(left.hi, -left.lo - 5);
}

TEST(HandMeshTest, SameInputSameBytes) {
  const HandMesh a = BuildHand(Person(81), Side::kRight, PoseOf(81), kCoarse);
  const HandMesh b = BuildHand(Person(81), Side::kRight, PoseOf(81), kCoarse);
  ASSERT_EQ(a.mesh.vertices.size(), b.mesh.vertices.size());
  EXPECT_EQ(std::memcmp(a.mesh.vertices.data(), b.mesh.vertices.data(),
                        a.mesh.vertices.size() * sizeof(Eigen::Vector3d)),
            0);
  EXPECT_EQ(std::memcmp(a.albedo.data(), b.albedo.data(), a.albedo.size() * sizeof(Eigen::Vector3f)), 0);
  EXPECT_EQ(a.mesh.faces, b.mesh.faces);
}

TEST(HandMeshTest, AlbedoIsSkin) {
  const HandMesh hand = BuildHand(Person(91), Side::kRight, PoseOf(91), kCoarse);
  ASSERT_EQ(hand.albedo.size(), hand.mesh.vertices.size());
  for (const Eigen::Vector3f& colour : hand.albedo) {
    EXPECT_GT(colour.minCoeff(), 0.1f);
    EXPECT_LT(colour.maxCoeff(), 0.95f);
    EXPECT_GT(colour.x(), colour.z());
  }
}

TEST(HandMeshTest, RefusesAnAbsurdResolution) {
  EXPECT_THROW(BuildHand(Person(1), Side::kRight, HandPose(), 0.0), std::logic_error);
}

}  // namespace
}  // namespace dorsum
