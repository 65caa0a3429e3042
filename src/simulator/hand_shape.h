// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "base/random.h"
#include "simulator/hand_pose.h"

namespace dorsum {

enum class Sex { kMan, kWoman };

// All measures in mm, of a right hand; a left hand is its mirror image.
struct FingerShape {
  double length = 0;         // tip to the midpoint of its base, fingers open (Hsiao 2015)
  double proximal_link = 0;  // MCP to PIP centre
  double middle_link = 0;    // PIP to DIP centre
  double distal_link = 0;    // DIP centre to the end of the tip
  double pip_breadth = 0, pip_depth = 0;
  double dip_breadth = 0, dip_depth = 0;
  double bow = 0;  // lateral offset of the DIP joint from the finger's straight line, towards the thumb
  double nail_breadth = 0, nail_length = 0;
};

struct ThumbShape {
  double length = 0;  // tip to MCP crease (Hsiao 2015); proximal and distal link together
  double metacarpal_link = 0, proximal_link = 0, distal_link = 0;
  double ip_breadth = 0, ip_depth = 0;
  double nail_breadth = 0, nail_length = 0;
};

// What no calliper measures yet is a person's own: drawn once with the shape and kept between visits.
struct HandDetail {
  std::uint64_t seed = 0;              // of creases, veins, relief and mottling
  std::array<double, 4> knuckle = {};  // height of each MCP bump over its surroundings, index first
  std::array<double, 4> tendon = {};   // height of each extensor ridge
  double vein = 0;                     // height of the veins
  double crease = 0;                   // depth of the deepest wrinkle over a PIP joint
  double relief = 0;                   // standard deviation of the smooth skin relief
  Eigen::Vector3f skin = Eigen::Vector3f::Zero();  // linear RGB reflectance
};

struct HandShape {
  double hand_length = 0;         // wrist crease to middle finger tip
  double palm_length = 0;         // wrist crease to the middle finger's palmar base crease
  double hand_breadth = 0;        // at the metacarpals, fingers closed
  double hand_breadth_open = 0;   // the same, fingers spread
  double hand_circumference = 0;  // at the metacarpals, fingers closed
  double palm_thickness = 0;      // at the head of metacarpal 3
  double wrist_breadth = 0;
  double wrist_circumference = 0;
  std::array<double, 4> crotch_height = {};  // from the wrist crease; thumb-index first
  std::array<FingerShape, 4> fingers;        // index, middle, ring, little
  ThumbShape thumb;
  HandDetail detail;

  double WristDepth() const;  // of a rounded section with the wrist's breadth and circumference
};

// One person: ANSUR II, Hsiao 2015 and Greiner 1991 means and standard deviations, with two common factors
// (size and breadth against length), one more for finger lengths, one for finger girths, and residuals; every
// standardised draw is clamped to +-2.8.
HandShape SampleHandShape(Sex sex, Rng& rng);

// The same person at another visit: girths change by 1.25 % (common) and 0.5 % (per finger), lengths by 0.3
// %.
HandShape VaryForSession(const HandShape& shape, Rng& rng);

}  // namespace dorsum
