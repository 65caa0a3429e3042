// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_pose.h"

#include <algorithm>

namespace dorsum {
namespace {

double NormalWithin(Rng& rng, double mean, double sd, double lo, double hi) {
  return std::clamp(mean + sd * rng.Normal(), lo, hi);
}

double AngleWithin(Rng& rng, double mean_deg, double sd_deg, double lo_deg, double hi_deg) {
  return Radians(NormalWithin(rng, mean_deg, sd_deg, lo_deg, hi_deg));
}

}  // namespace

HandPose SampleHandPose(Rng& rng) {
  HandPose pose;
  pose.yaw = AngleWithin(rng, 0, 3.5, -8, 8);
  pose.centre.x() = NormalWithin(rng, 0, 3.5, -8, 8);
  pose.centre.y() = NormalWithin(rng, 0, 3.5, -8, 8);
  const double openness = rng.Normal();  // a hand that opens wide opens between all fingers
  constexpr std::array<double, 3> kMeanSpread = {8.5, 7.0, 9.0};
  for (int i = 0; i < 3; ++i) pose.spread[i] = AngleWithin(rng, kMeanSpread[i] + 1.3 * openness, 1.0, 4, 12);
  pose.middle_deviation = AngleWithin(rng, 0, 1.0, -2.5, 2.5);
  const double curl = rng.Normal();
  for (int i = 0; i < 4; ++i) {
    pose.pip_flexion[i] = AngleWithin(rng, 7 + 2.0 * curl, 1.2, 1, 14);
    pose.dip_flexion[i] = AngleWithin(rng, 3 + 0.8 * curl, 0.8, 0, 7);
  }
  pose.thumb_abduction = AngleWithin(rng, 44, 3.5, 36, 52);
  pose.thumb_mcp_bend = AngleWithin(rng, 12, 3.0, 4, 20);
  pose.thumb_ip_bend = AngleWithin(rng, 5, 3.0, -3, 12);
  pose.thumb_roll = AngleWithin(rng, 35, 4.0, 25, 45);
  pose.wrist_deviation = AngleWithin(rng, 0, 2.5, -6, 6);
  return pose;
}

}  // namespace dorsum
