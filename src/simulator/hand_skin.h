// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "simulator/hand_bodies.h"
#include "simulator/hand_detail.h"
#include "simulator/skin_noise.h"

namespace dorsum {

// The skin of a right hand in its own frame (see HandSkeleton) as the zero set of a signed distance.
class HandSkin {
 public:
  HandSkin(const HandShape& shape, const HandPose& pose);

  double Distance(const Eigen::Vector3d& point) const;  // mm, negative inside; never negative below z = 0
  Eigen::Vector3f Albedo(const Eigen::Vector3d& point) const;  // linear RGB reflectance of the skin there
  double Nail(const Eigen::Vector3d& point) const;             // share of nail plate there, 0 to 1
  const HandSkeleton& Skeleton() const { return skeleton_; }
  void Bounds(Eigen::Vector3d& lo, Eigen::Vector3d& hi) const;  // of a box that holds the skin

 private:
  struct Blend {
    double distance;         // without any detail
    double finger;           // to the nearest finger or thumb, to weigh its details
    SweptBody::Place place;  // on it
    int digit;               // 0 thumb, 1 index … 4 little
  };
  Blend Smooth(const Eigen::Vector3d& point) const;
  SkinDetail DetailAt(const Eigen::Vector3d& point, const Blend& blend) const;
  double WebEnd(int i) const;  // how far past its crotch the web between two fingers reaches
  void FitWebs();

  HandShape shape_;
  HandSkeleton skeleton_;
  HandBodies bodies_;
  std::array<BlendedBody, 4> webs_;
  std::vector<FingerDetail> details_;  // thumb first
  DorsumDetail dorsum_;
  SkinNoise relief_, mottling_;
};

}  // namespace dorsum
