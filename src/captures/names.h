// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

namespace dorsum {

// The document's names of images, without extension (§3.2, §3.3; DESIGN §4). Lasers count from 0.
inline constexpr int kMaxLasers = 8;
inline constexpr int kChessViews = 12;

inline std::string ChessName(int view) { return (view < 10 ? "chess0" : "chess") + std::to_string(view); }

// The two distances at which the document observes each laser (§3.2).
enum class Distance { kFurther, kCloser };

inline const char* DistanceName(Distance d) { return d == Distance::kFurther ? "Further" : "Closer"; }

inline std::string LaserBgName(Distance d) { return std::string("laserCal") + DistanceName(d) + "Bg"; }
inline std::string LaserCalName(int laser, Distance d) {
  return "laser" + std::to_string(laser) + "Cal" + DistanceName(d);
}
inline std::string LaserChessName(int laser, Distance d) { return LaserCalName(laser, d) + "Chess"; }
inline std::string StripesBgName(int laser) { return "stripesBg" + std::to_string(laser); }
inline std::string StripesHandName(int laser) { return "stripesHand" + std::to_string(laser); }

inline constexpr const char* kFirstEstimatesName = "laserFirstEstimates";
inline constexpr const char* kBgNoHandName = "bgNoHand";
inline constexpr const char* kBgHandName = "bgHand";
inline constexpr const char* kBgHandAfterName = "bgHandAfter";
inline constexpr const char* kSetupName = "setup.json";
inline constexpr const char* kHeightsFolder = "heights";

// Folder of a box series below heights/: "h13.5".
inline std::string HeightFolderName(double height_mm) {
  const long tenths = std::lround(height_mm * 10.0);
  return "h" + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace dorsum
