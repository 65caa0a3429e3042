// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "simulator/hand_skeleton.h"
#include "simulator/swept_body.h"

namespace dorsum {

// What lies on the skin at one place: a height over it in mm and shares of colour in [0, 1].
struct SkinDetail {
  double height = 0;
  double crease = 0;  // in a wrinkle
  double nail = 0;    // on the nail plate
  double pale = 0;    // lunula and free edge of the nail
  double flush = 0;   // redder skin over a joint
};

// Creases over the joints and the nail of one finger (or the thumb), in its body's coordinates.
class FingerDetail {
 public:
  struct Joint {
    double s;           // mm along the body
    double half_width;  // of the finger there
    double depth;       // of the deepest wrinkle
    int wrinkles;       // odd
  };
  FingerDetail(const std::vector<Joint>& joints, double nail_from, double nail_breadth, double nail_length,
               Rng& rng);
  SkinDetail At(const SweptBody::Place& place) const;

 private:
  struct Wrinkle {
    double s, depth, bow, reach, wave, phase;
  };
  void AddWrinkles(const SweptBody::Place& place, double dorsal, SkinDetail& detail) const;
  void AddNail(const SweptBody::Place& place, double dorsal, SkinDetail& detail) const;

  std::vector<Joint> joints_;
  std::vector<Wrinkle> wrinkles_;
  double nail_middle_, nail_half_breadth_, nail_half_length_;
};

// Tendons, knuckles, veins and the head of the ulna under the skin of the back of the hand.
class DorsumDetail {
 public:
  DorsumDetail(const HandShape& shape, const HandSkeleton& skeleton);
  double Height(const Eigen::Vector3d& point) const;
  double Vein(const Eigen::Vector3d& point) const;  // share in [0, 1]: veins look darker as well

 private:
  struct Ridge {
    Eigen::Vector2d from, to;
    double height, width;
  };
  struct Bump {
    Eigen::Vector3d centre;
    double height, along, across;
  };
  struct VeinLine {
    Eigen::Vector2d from, to;
    double height, width, wave, length, phase;
  };
  std::vector<Ridge> tendons_;
  std::vector<Bump> bumps_;
  std::vector<VeinLine> veins_;
};

}  // namespace dorsum
