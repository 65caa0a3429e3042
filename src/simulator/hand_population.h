// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace dorsum {

struct MeanSd {
  double mean, sd;
  double At(double z) const { return mean + sd * z; }
};

// Means and standard deviations in mm. Lengths and breadths of the hand: ANSUR II; fingers and the open
// hand's breadth: Hsiao 2015; wrist breadth and circumferences of the fingers: Greiner 1991; palm thickness:
// AIST.
struct Population {
  MeanSd hand_length, palm_length, hand_breadth, hand_breadth_open, hand_circumference;
  MeanSd wrist_circumference, wrist_breadth, palm_thickness;
  MeanSd thumb_length, thumb_breadth;
  std::array<MeanSd, 4> finger_length, finger_breadth;
  std::array<double, 4> pip_circumference, dip_circumference;  // of ring and little at DIP: the index's ratio
  double thumb_circumference;
  double crotch_drop_little;  // ring-little crotch below the two central ones
  double crotch_thumb_ratio;  // thumb-index crotch over the mean of the two central ones
};

inline constexpr Population kMen = {{193.3, 10.0},
                                    {116.5, 6.2},
                                    {88.3, 4.4},
                                    {97.2, 4.6},
                                    {212.3, 10.2},
                                    {175.9, 9.0},
                                    {65.8, 4.5},
                                    {32.1, 2.2},
                                    {70.8, 4.3},
                                    {24.4, 1.6},
                                    {{{75.8, 4.4}, {83.8, 4.6}, {79.6, 4.5}, {65.2, 4.3}}},
                                    {{{22.7, 1.6}, {22.4, 1.7}, {21.7, 1.6}, {19.8, 1.5}}},
                                    {68.4, 69.6, 64.9, 57.8},
                                    {57.4, 57.8, 54.2, 48.8},
                                    72.3,
                                    13.6,
                                    0.627};
inline constexpr Population kWomen = {{181.1, 10.1},
                                      {108.7, 5.9},
                                      {78.2, 3.8},
                                      {87.4, 4.2},
                                      {186.6, 8.8},
                                      {154.8, 7.8},
                                      {57.0, 3.4},
                                      {27.8, 1.9},
                                      {64.8, 4.1},
                                      {21.5, 1.5},
                                      {{{71.3, 4.2}, {78.6, 4.5}, {74.0, 4.5}, {60.4, 4.3}}},
                                      {{{20.5, 1.2}, {20.3, 1.3}, {19.4, 1.2}, {17.5, 1.2}}},
                                      {61.2, 61.3, 57.4, 50.6},
                                      {50.8, 50.9, 47.9, 42.7},
                                      63.0,
                                      12.5,
                                      0.626};

inline constexpr double kDipBreadthRatio = 0.86;  // DIP over PIP breadth
// Surface distance from MCP to crotch for a palm of 116.5 mm: Greiner's three links less Hsiao's length.
inline constexpr std::array<double, 4> kMcpToBase = {26.0, 26.1, 25.0, 22.0};
// Shares of the three links in MCP to tip; the middle finger's are Greiner's, the others follow its pattern.
inline constexpr double kLinkShare[4][3] = {
    {0.493, 0.238, 0.269}, {0.499, 0.240, 0.261}, {0.487, 0.249, 0.264}, {0.482, 0.228, 0.290}};

}  // namespace dorsum
