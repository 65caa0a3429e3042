// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/camera.h"
#include "jobs/reconstruct.h"

namespace dorsum {

struct FingerQuality {
  double covered = 0.0;   // share of the finger, as the camera sees it, that the surface covers
  double sigma_mm = 0.0;  // usual (median) standard deviation of its points' heights; 0: it has none
  int points = 0;
};

// From left to right as a person sees the back of the own hand (studio/hand_fingers.h). Empty where five
// fingers cannot be told apart.
std::vector<FingerQuality> JudgeFingers(const Reconstruction& surface, const Camera& camera);

}  // namespace dorsum
